/** An application that is a module: it requires one module of Lazy Z, and nothing else because of it. */
module example {
    requires dev.lazyz.scenes;
}
