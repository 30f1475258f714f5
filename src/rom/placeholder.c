typedef int hawser__placeholder_rom;
