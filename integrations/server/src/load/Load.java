import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Load JAR [SECONDS [CLIENTS]]: starts lazyz-server with a heap of 256 MB, and sends it requests for a while, by
 * clients of which half want pictures, and the others are slow, wrong, or gone before the answer. Prints what became of
 * the requests, and the heap after a collection at the start and at the end. Exits with 1 if a request for a picture
 * was lost, or a picture had wrong bits. A refused request (429, 503) is not lost: it is sent again.
 */
public class Load {
    private static final HttpClient HTTP =
            HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).build();
    private static final AtomicLong LOST = new AtomicLong();
    private static final Map<String, AtomicLong> COUNTS = new ConcurrentSkipListMap<>();
    private static final Map<String, String> TAGS = new ConcurrentHashMap<>();
    private static final ConcurrentLinkedQueue<Long> TIMES = new ConcurrentLinkedQueue<>();
    private static volatile long end;
    private static int port;
    private static int adminPort;

    public static void main(String[] args) throws Exception {
        int seconds = args.length > 1 ? Integer.parseInt(args[1]) : 60;
        int clients = args.length > 2 ? Integer.parseInt(args[2]) : 64;
        Process server = new ProcessBuilder(
                        program("java"), "-Xmx256m", "-jar", args[0], //
                        "--port", "0", "--admin-port", "0", "--upload-time", "10", "--queue", "32")
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        try {
            readPorts(server);
            // Classes and compiled code are there after the first requests
            end = System.nanoTime() + 5_000_000_000L;
            run(clients);
            long before = heapAfterCollection(server);
            COUNTS.clear();
            TIMES.clear();
            end = System.nanoTime() + seconds * 1_000_000_000L;
            run(clients);
            await("lazyz_requests_open", 0);
            long after = heapAfterCollection(server);
            report(seconds, clients, before, after);
        } finally {
            server.destroy();
            server.waitFor();
        }
        System.exit(LOST.get() == 0 ? 0 : 1);
    }

    private static String program(String name) {
        return System.getProperty("java.home") + "/bin/" + name;
    }

    /** Reads the ports from the first two lines of the log, and drops the other lines. */
    private static void readPorts(Process server) throws IOException {
        var lines = server.inputReader();
        port = URI.create(lines.readLine().split("(?=http)")[1]).getPort();
        adminPort = URI.create(lines.readLine().split("(?=http)")[1]).getPort();
        Thread reader = new Thread(() -> lines.lines().forEach(line -> {}));
        reader.setDaemon(true);
        // The pipe is closed when the server ends
        reader.setUncaughtExceptionHandler((thread, closed) -> {});
        reader.start();
    }

    private static void run(int clients) throws InterruptedException {
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < clients; i++) {
            int number = i;
            Thread thread = new Thread(() -> client(number));
            thread.start();
            threads.add(thread);
        }
        for (Thread thread : threads) thread.join();
    }

    private static void client(int number) {
        Random random = new Random(number);
        while (System.nanoTime() < end) {
            try {
                switch (number % 8) {
                    case 4 -> slow();
                    case 5 -> wrong(random);
                    case 6 -> gone(random);
                    case 7 -> bomb(random);
                    default -> picture(random);
                }
            } catch (IOException e) {
                // A client that wants a picture has counted this already
            } catch (InterruptedException e) {
                return;
            }
        }
    }

    /** Sends a model until there is a picture, and compares it with earlier ones of the same request. */
    private static void picture(Random random) throws IOException, InterruptedException {
        int side = new int[] {8, 30, 60, 100}[random.nextInt(4)];
        boolean isStl = random.nextBoolean();
        String path = "/render?size=" + (random.nextBoolean() ? 128 : 512) + "&format=" + (isStl ? "stl" : "obj");
        byte[] model = isStl ? stl(side) : obj(side);
        long start = System.nanoTime();
        while (true) {
            HttpResponse<byte[]> answer;
            try {
                answer = post(path, model);
            } catch (IOException e) {
                count("pictures lost: " + e);
                LOST.incrementAndGet();
                return;
            }
            count("pictures, status " + answer.statusCode());
            if (answer.statusCode() == 429 || answer.statusCode() == 503) {
                if (System.nanoTime() > end) return;
                Thread.sleep(100 + random.nextInt(400));
                continue;
            }
            String tag = answer.headers().firstValue("etag").orElse("");
            String known = TAGS.putIfAbsent(path + side, tag);
            boolean isRight = answer.statusCode() == 200 && (known == null || known.equals(tag));
            if (!isRight) LOST.incrementAndGet();
            TIMES.add(System.nanoTime() - start);
            return;
        }
    }

    private static void slow() throws IOException, InterruptedException {
        try (Socket socket = new Socket("127.0.0.1", port)) {
            OutputStream out = socket.getOutputStream();
            out.write(ascii("POST /render HTTP/1.1\r\nHost: x\r\nContent-Length: 1000000\r\n\r\n"));
            for (int i = 0; i < 1000; i++) {
                out.write('#');
                Thread.sleep(50);
            }
            count("slow clients that were not cut off");
        } catch (IOException e) {
            count("slow clients that were cut off");
        }
    }

    private static void wrong(Random random) throws IOException, InterruptedException {
        byte[] noise = new byte[random.nextInt(100_000)];
        random.nextBytes(noise);
        String[] formats = {"obj", "stl", "ply", "off", "3mf", "glb", "gltf"};
        count("noise, status " + post("/render?format=" + formats[random.nextInt(7)], noise).statusCode());
    }

    private static void gone(Random random) throws IOException, InterruptedException {
        byte[] model = obj(60);
        try (Socket socket = new Socket("127.0.0.1", port)) {
            OutputStream out = socket.getOutputStream();
            out.write(ascii("POST /render?size=2048&aa=8 HTTP/1.1\r\nHost: x\r\n"));
            out.write(ascii("Content-Length: " + model.length + "\r\n\r\n"));
            out.write(model);
            Thread.sleep(random.nextInt(300));
        }
        count("clients that went away");
    }

    private static void bomb(Random random) throws IOException, InterruptedException {
        boolean isZip = random.nextBoolean();
        String path = "/render?format=" + (isZip ? "3mf" : "off");
        byte[] bomb = isZip ? zip() : ascii("OFF\n1000000000 1000000000 0\n0 0 0\n");
        count("bombs, status " + post(path, bomb).statusCode());
        if (random.nextInt(4) == 0) Thread.sleep(100);
    }

    private static HttpResponse<byte[]> post(String path, byte[] body) throws IOException, InterruptedException {
        HttpRequest request = HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + path))
                .timeout(Duration.ofSeconds(120))
                .POST(HttpRequest.BodyPublishers.ofByteArray(body))
                .build();
        return HTTP.send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    /** A bumpy square of side x side x 2 triangles. */
    private static byte[] obj(int side) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i <= side; i++) {
            for (int j = 0; j <= side; j++) {
                text.append("v ").append(i).append(' ').append(height(i, j)).append(' ').append(j).append('\n');
            }
        }
        for (int i = 0; i < side; i++) {
            for (int j = 1; j <= side; j++) {
                int a = i * (side + 1) + j;
                text.append("f ").append(a).append(' ').append(a + 1);
                text.append(' ').append(a + side + 2).append(' ').append(a + side + 1).append('\n');
            }
        }
        return ascii(text.toString());
    }

    private static byte[] stl(int side) {
        ByteBuffer bytes = ByteBuffer.allocate(84 + 100 * side * side).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putInt(80, 2 * side * side).position(84);
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                int[][] corners = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j}, {i + 1, j + 1}, {i, j + 1}};
                for (int k = 0; k < 6; k++) {
                    if (k % 3 == 0) bytes.putFloat(0).putFloat(0).putFloat(0);
                    int[] c = corners[k];
                    bytes.putFloat(c[0]).putFloat(c[1]).putFloat(height(c[0], c[1]));
                    if (k % 3 == 2) bytes.putShort((short) 0);
                }
            }
        }
        return bytes.array();
    }

    private static int height(int i, int j) {
        return (i * 7 + j * 13) % 5;
    }

    /** 100 MB of spaces. */
    private static byte[] zip() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            zip.putNextEntry(new ZipEntry("3D/3dmodel.model"));
            zip.write(ascii("<model unit='millimeter'>"));
            byte[] spaces = new byte[1 << 20];
            Arrays.fill(spaces, (byte) ' ');
            for (int i = 0; i < 100; i++) zip.write(spaces);
        }
        return bytes.toByteArray();
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static void count(String what) {
        COUNTS.computeIfAbsent(what, it -> new AtomicLong()).incrementAndGet();
    }

    private static Map<String, Double> metrics() throws IOException, InterruptedException {
        HttpRequest request =
                HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + adminPort + "/metrics")).build();
        Map<String, Double> metrics = new TreeMap<>();
        String page = HTTP.send(request, HttpResponse.BodyHandlers.ofString()).body();
        page.lines().filter(it -> !it.startsWith("#")).forEach(it -> {
            int space = it.lastIndexOf(' ');
            metrics.put(it.substring(0, space), Double.parseDouble(it.substring(space + 1)));
        });
        return metrics;
    }

    /** Waits until a number is small enough. */
    private static void await(String gauge, int value) throws IOException, InterruptedException {
        for (int i = 0; i < 3000 && metrics().get(gauge) > value; i++) Thread.sleep(10);
    }

    private static long heapAfterCollection(Process server) throws Exception {
        for (int i = 0; i < 2; i++) {
            new ProcessBuilder(program("jcmd"), "" + server.pid(), "GC.run")
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start()
                    .waitFor();
        }
        return metrics().get("jvm_memory_used_bytes").longValue();
    }

    private static void report(int seconds, int clients, long before, long after) throws Exception {
        System.out.printf("%d clients, %d seconds%n", clients, seconds);
        COUNTS.forEach((what, count) -> System.out.printf("%8d %s%n", count.get(), what));
        List<Long> times = TIMES.stream().sorted().toList();
        System.out.printf(
                "pictures: median %d ms, 99 %% below %d ms, with repetitions%n",
                times.get(times.size() / 2) / 1_000_000, times.get(times.size() * 99 / 100) / 1_000_000);
        System.out.printf(
                "heap after a collection: %.1f MiB at the start, %.1f MiB at the end%n",
                before / 1048576.0, after / 1048576.0);
        Map<String, Double> metrics = metrics();
        for (String name : List.of("upload_memory_bytes", "render_memory_bytes", "renders_waiting")) {
            System.out.printf("lazyz_%s %.0f%n", name, metrics.get("lazyz_" + name));
        }
        System.out.println(LOST.get() + " lost or wrong");
    }
}
