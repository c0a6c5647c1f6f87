package dev.lazyz.jmh.stages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.Frame;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class StageMapTest {
    @Test
    void eachClassOfThePackagesHasARule() throws Exception {
        Set<String> classes = classes(Frame.class);
        for (String name : StageMap.PACKAGES) {
            assertTrue(classes.stream().anyMatch(type -> isIn(name, type)), "no package " + name);
        }
        List<String> missing = classes.stream()
                .filter(type -> StageMap.PACKAGES.stream().anyMatch(name -> isIn(name, type)))
                .filter(type -> StageMap.find(StageMap.ROOT + type, "any").kind() == StageMap.Kind.NONE)
                .toList();
        assertEquals(List.of(), missing, "add a rule to StageMap");
    }

    @Test
    void eachRuleNamesAPackageAClassOrAMethod() throws Exception {
        Set<String> classes = classes(Frame.class);
        classes.addAll(classes(StageMap.class));
        List<String> wrong =
                StageMap.names().stream().filter(name -> !exists(name, classes)).toList();
        assertEquals(List.of(), wrong, "remove these rules from StageMap, or correct them");
    }

    @Test
    void theLongestNameDecides() {
        assertEquals(Stage.RESOLVE, stage("strategies.tiled.resolve.TileShading", "shadeRow"));
        assertEquals(Stage.INTERPOLATE, stage("strategies.tiled.resolve.TileShading", "gather"));
        assertEquals(Stage.ENCODE, stage("strategies.tiled.resolve.VectorFragmentKernel$Component", "find"));
        assertEquals(Stage.COVER, stage("strategies.tiled.raster.VectorBlockKernel$Companion", "wholeColumn"));
        assertEquals(Stage.SHADE, stage("shading.pbr.Microfacets", "any"));
        assertEquals(
                StageMap.Kind.CALLER,
                StageMap.find("dev.lazyz.FragmentBatch", "any").kind());
        assertEquals(
                StageMap.Kind.NONE,
                StageMap.find("dev.lazyz.unknown.Type", "any").kind());
        assertEquals(
                StageMap.Kind.NONE, StageMap.find("java.util.Arrays", "fill").kind());
    }

    private static Stage stage(String type, String method) {
        return StageMap.find(StageMap.ROOT + type, method).stage();
    }

    private static boolean isIn(String name, String type) {
        return type.startsWith(name + ".");
    }

    private static boolean exists(String name, Set<String> classes) {
        if (name.endsWith("*")) {
            return classes.stream().anyMatch(type -> type.startsWith(name.substring(0, name.length() - 1)));
        }
        if (classes.contains(name)) {
            return true;
        }
        int dot = name.lastIndexOf('.');
        if (!classes.contains(name.substring(0, dot))) {
            return false;
        }
        try {
            Class<?> type = Class.forName(StageMap.ROOT + name.substring(0, dot), false, Frame.class.getClassLoader());
            return Arrays.stream(type.getDeclaredMethods())
                    .anyMatch(method -> method.getName().equals(name.substring(dot + 1)));
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns the names, without {@link StageMap#ROOT}, of all classes in the jar or folder of {@code example}. */
    private static Set<String> classes(Class<?> example) throws IOException, URISyntaxException {
        Path place = Path.of(
                example.getProtectionDomain().getCodeSource().getLocation().toURI());
        if (Files.isDirectory(place)) {
            return classes(place);
        }
        try (FileSystem jar = FileSystems.newFileSystem(place)) {
            return classes(jar.getPath("/"));
        }
    }

    private static Set<String> classes(Path root) throws IOException {
        Set<String> names = new TreeSet<>();
        try (Stream<Path> files = Files.walk(root.resolve("dev/lazyz"))) {
            files.map(file ->
                            root.relativize(file).toString().replace('\\', '/').replace('/', '.'))
                    .filter(name -> name.endsWith(".class"))
                    .map(name -> name.substring(StageMap.ROOT.length(), name.length() - ".class".length()))
                    .forEach(names::add);
        }
        return names;
    }
}
