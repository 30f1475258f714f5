# notebooks-data
