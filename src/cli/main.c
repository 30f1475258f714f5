#include <stdio.h>
#include <hawser/hawser.h>

int main(void)
{
	printf("hawser %s\n", hawser_version());
	return 0;
}
