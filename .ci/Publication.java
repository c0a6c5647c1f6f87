import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.zip.ZipFile;
import javax.xml.parsers.DocumentBuilderFactory;
import org.w3c.dom.Element;
import org.w3c.dom.Node;

/**
 * Publication FOLDER [ARTIFACT...]: checks that a folder, which is laid out as a Maven repository, contains what Maven
 * Central demands of a release, for the libraries, the BOM and the further artifacts named, which are POMs only. Run it
 * in the root of the clone. Prints each fault, and exits with 1 if there is one.
 */
public class Publication {
    private static final List<String> MODULES =
            List.of("core", "scenes", "conformance", "testing", "server", "spark", "swing");
    private static final List<String> FACTS = List.of("name", "description", "url", "licenses", "developers", "scm");
    private static final Map<String, String> CHECKSUMS = Map.of("md5", "MD5", "sha1", "SHA-1");

    private final Path group;
    private final List<String> faults = new ArrayList<>();

    private Publication(Path folder) {
        group = folder.resolve("dev/lazyz");
    }

    public static void main(String[] args) throws Exception {
        Publication publication = new Publication(Path.of(args[0]));
        TreeSet<String> expected = new TreeSet<>(List.of(args).subList(1, args.length));
        expected.add("lazyz-bom");
        for (String module : MODULES) expected.add("lazyz-" + module);
        publication.check(expected);
        publication.faults.forEach(System.err::println);
        System.out.println(expected + ": " + publication.faults.size() + " faults");
        System.exit(publication.faults.isEmpty() ? 0 : 1);
    }

    private void check(TreeSet<String> expected) throws Exception {
        TreeSet<String> found = new TreeSet<>(names(group));
        if (!found.equals(expected)) faults.add("published are " + found + ", expected " + expected);
        for (String artifact : found) {
            List<String> versions = names(group.resolve(artifact)).stream()
                    .filter(it -> !it.startsWith("maven-metadata"))
                    .collect(Collectors.toList());
            if (versions.size() != 1) faults.add(artifact + " has the versions " + versions);
            Path folder = group.resolve(artifact).resolve(versions.get(0));
            String file = artifact + "-" + versions.get(0);
            pom(folder.resolve(file + ".pom"));
            checksums(folder);
            String module = artifact.substring("lazyz-".length());
            if (MODULES.contains(module)) {
                jar(folder.resolve(file + ".jar"), "META-INF/MANIFEST.MF", "\\.class$");
                jar(folder.resolve(file + "-sources.jar"), "META-INF/MANIFEST.MF", "\\.kt$");
                documentation(module, folder.resolve(file + "-javadoc.jar"));
            }
        }
    }

    /** The facts that a POM must state, itself or in its parent; nothing of it may change after the release. */
    private void pom(Path file) throws Exception {
        if (!Files.exists(file)) {
            faults.add("not there: " + file);
            return;
        }
        Element pom = xml(file);
        Element parent = child(pom, "parent");
        if (parent != null) {
            String version = child(parent, "version").getTextContent();
            String name = child(parent, "artifactId").getTextContent();
            parent = xml(group.resolve(name).resolve(version).resolve(name + "-" + version + ".pom"));
        }
        for (String fact : FACTS) {
            boolean own = List.of("name", "description").contains(fact);
            Element element = child(pom, fact);
            if (element == null && parent != null && !own) element = child(parent, fact);
            if (element == null || element.getTextContent().isBlank()) faults.add(file + " has no <" + fact + ">");
        }
        String text = Files.readString(file);
        for (String word : List.of("SNAPSHOT", "<repositories>", "<pluginRepositories>", "<systemPath>")) {
            if (text.contains(word)) faults.add(file + " contains " + word);
        }
    }

    private void checksums(Path folder) throws Exception {
        for (String name : names(folder)) {
            if (!name.matches(".*\\.(jar|pom|module)")) continue;
            for (Map.Entry<String, String> checksum : CHECKSUMS.entrySet()) {
                byte[] bytes = Files.readAllBytes(folder.resolve(name));
                byte[] digest = MessageDigest.getInstance(checksum.getValue()).digest(bytes);
                Path file = folder.resolve(name + "." + checksum.getKey());
                boolean right = Files.exists(file)
                        && Files.readString(file).trim().equals(HexFormat.of().formatHex(digest));
                if (!right) faults.add("missing or wrong: " + file);
            }
        }
    }

    private void jar(Path file, String entry, String contents) throws IOException {
        if (!Files.exists(file)) {
            faults.add("not there: " + file);
            return;
        }
        Pattern pattern = Pattern.compile(contents);
        try (ZipFile zip = new ZipFile(file.toFile())) {
            if (zip.getEntry(entry) == null) faults.add(file + " has no " + entry);
            if (zip.stream().noneMatch(it -> pattern.matcher(it.getName()).find())) faults.add(file + " is empty");
        }
    }

    /** The pages show each public package with its text, each public type, and no others. */
    private void documentation(String module, Path file) throws IOException {
        jar(file, "index.html", "\\.html$");
        if (!Files.exists(file)) return;
        TreeSet<String> types = new TreeSet<>();
        // Classes that only hold functions of a file are pages of their package
        TreeSet<String> holders = holders(module);
        Pattern type = Pattern.compile("(?m)^public .*(?:class|interface) ([\\w/]+)/([\\w$]+) .*\\{$");
        type.matcher(Files.readString(folder(module).resolve("api/lazyz-" + module + ".api"))).results().forEach(match -> {
            String name = match.group(2).replace('$', '.');
            if (!holders.contains(name)) types.add(match.group(1).replace('/', '.') + "/" + name);
        });
        TreeSet<String> shown = new TreeSet<>();
        try (ZipFile zip = new ZipFile(file.toFile())) {
            var listing = zip.getEntry("lazyz-" + module + "/package-list");
            String list = new String(zip.getInputStream(listing).readAllBytes());
            // Constants of an enum class have locations, too
            Pattern location =
                    Pattern.compile("(?m)^\\$dokka\\.location:([\\w.]+)/((?:\\w+\\.)*[A-Z]\\w*[a-z]\\w*)///Point");
            location.matcher(list).results().forEach(match -> shown.add(match.group(1) + "/" + match.group(2)));
            for (String part : Files.readString(folder(module).resolve("api/packages.md")).split("(?m)^# Package ")) {
                if (part.startsWith("# Module")) continue;
                String name = part.lines().findFirst().orElseThrow();
                String words = part.substring(name.length()).strip().split("[`.:,;\n]")[0];
                var page = zip.getEntry("lazyz-" + module + "/" + name + "/index.html");
                if (page == null || !new String(zip.getInputStream(page).readAllBytes()).contains(words)) {
                    faults.add(file + " does not say of package " + name + ": " + words);
                }
            }
        }
        // A companion without documented members has no page
        types.removeIf(it -> it.endsWith(".Companion") && !shown.contains(it));
        TreeSet<String> missing = new TreeSet<>(types);
        missing.removeAll(shown);
        if (!missing.isEmpty()) faults.add(file + " does not show " + missing);
        shown.removeAll(types);
        if (!shown.isEmpty()) faults.add(file + " shows what is not public: " + shown);
    }

    /** The folder of a module: in the root of the clone, or among the integrations. */
    private static Path folder(String module) {
        Path folder = Path.of(module);
        return Files.exists(folder) ? folder : Path.of("integrations", module);
    }

    private static TreeSet<String> holders(String module) throws IOException {
        TreeSet<String> names = new TreeSet<>();
        Pattern name = Pattern.compile("(?m)^@file:JvmName\\(\"(\\w+)\"\\)$");
        try (var files = Files.walk(folder(module).resolve("src/main/kotlin"))) {
            for (Path file : (Iterable<Path>) files.filter(it -> it.toString().endsWith(".kt"))::iterator) {
                names.add(file.getFileName().toString().replace(".kt", "Kt"));
                name.matcher(Files.readString(file)).results().forEach(it -> names.add(it.group(1)));
            }
        }
        return names;
    }

    private static List<String> names(Path folder) throws IOException {
        try (var files = Files.list(folder)) {
            return files.map(it -> it.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }

    private static Element xml(Path file) throws Exception {
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile()).getDocumentElement();
    }

    private static Element child(Element parent, String name) {
        for (Node node = parent.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node.getNodeName().equals(name)) return (Element) node;
        }
        return null;
    }
}
