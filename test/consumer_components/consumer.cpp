// Here the projects are what is tested: that they can be configured, compiled and linked.
int main() {}
