import java.awt.image.BufferedImage;
import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.zip.InflaterInputStream;
import javax.imageio.ImageIO;

/**
 * java .ci/LargePicture.java [input [side [heap [rows [option...]]]]]: renders a picture larger than memory to a PNG,
 * decodes it with a decoder of its own, row by row, and compares random rows with what --region renders of them. Prints
 * time, memory and size. Fails if a row differs. By default ten gigapixels of the teapot with 256 MB: java
 * .ci/LargePicture.java teapot 100000 256m 12. Further options are those of zcli render.
 *
 * Needs zcli.jar, and some gigabytes in target/large-picture, which is deleted at the end. Not a part of .ci/run.
 */
public class LargePicture {
    public static void main(String[] args) throws Exception {
        String input = args.length > 0 ? args[0] : "teapot";
        int side = args.length > 1 ? Integer.parseInt(args[1]) : 100_000;
        String heap = args.length > 2 ? args[2] : "256m";
        int count = args.length > 3 ? Integer.parseInt(args[3]) : 12;
        Path folder = Files.createDirectories(Path.of("target", "large-picture"));
        Path picture = folder.resolve("picture.png");

        List<String> render = new ArrayList<>(List.of("render", input, "--size", side + "x" + side, "--aa", "1"));
        render.addAll(Arrays.asList(args).subList(Math.min(4, args.length), args.length));
        String cost = zcli(heap, render, "-o", picture.toString());
        System.out.printf("%dx%d of %s, -Xmx%s: %s, %,d bytes%n", side, side, input, heap, cost, Files.size(picture));

        Random random = new Random(side);
        TreeSet<Integer> rows = new TreeSet<>(List.of(0, side / 2, side - 1));
        while (rows.size() < count) {
            rows.add(side / 4 + random.nextInt(side / 2)); // where the model is
        }
        int different = 0;
        try (Decoder decoder = new Decoder(picture)) {
            int y = 0;
            for (int row : rows) {
                while (y <= row) {
                    decoder.next();
                    y++;
                }
                Path part = folder.resolve("row.png");
                zcli(heap, render, "--region", "0," + row + "," + side + "x1", "-o", part.toString());
                BufferedImage expected = ImageIO.read(part.toFile());
                int[] colors = expected.getRGB(0, 0, side, 1, null, 0, side);
                boolean isSame = Arrays.equals(colors, decoder.colors());
                long distinct = Arrays.stream(colors).distinct().count();
                System.out.printf("row %d: %s, %d colours%n", row, isSame ? "same" : "DIFFERENT", distinct);
                different += isSame ? 0 : 1;
            }
        }
        Files.delete(folder.resolve("row.png"));
        Files.delete(picture);
        System.exit(different == 0 ? 0 : 1);
    }

    /** Runs zcli, and returns its time and, on Linux, the most memory that it had. */
    private static String zcli(String heap, List<String> words, String... more) throws Exception {
        List<String> command = new ArrayList<>(List.of("java", "-Xmx" + heap, "-jar", "cli/target/zcli.jar"));
        command.addAll(words);
        command.addAll(List.of(more));
        long start = System.nanoTime();
        Process process = new ProcessBuilder(command).inheritIO().start();
        String peak = "unknown";
        while (!process.waitFor(200, TimeUnit.MILLISECONDS)) {
            Path status = Path.of("/proc", String.valueOf(process.pid()), "status");
            try {
                for (String line : Files.readAllLines(status)) {
                    if (line.startsWith("VmHWM:")) {
                        peak = Pattern.compile("[^0-9]+").matcher(line).replaceAll("");
                    }
                }
            } catch (IOException ended) {
                // The process has just ended, or this is not Linux
            }
        }
        if (process.exitValue() != 0) {
            throw new IllegalStateException("zcli failed: " + command);
        }
        return (System.nanoTime() - start) / 1_000_000_000 + " s, " + peak + " KiB resident at most";
    }

    /** The rows of a PNG with 8 bits a channel, RGB. */
    private static final class Decoder implements AutoCloseable {
        private final DataInputStream file;
        private final DataInputStream rows;
        private byte[] above;
        private byte[] row;

        Decoder(Path path) throws IOException {
            file = new DataInputStream(new BufferedInputStream(Files.newInputStream(path), 1 << 16));
            file.skipNBytes(16);
            int width = file.readInt();
            file.skipNBytes(4);
            if (file.readInt() >>> 16 != 0x0802) {
                throw new IOException("not RGB with 8 bits");
            }
            file.skipNBytes(5);
            above = new byte[3 * width + 3];
            row = new byte[3 * width + 3];
            rows = new DataInputStream(new InflaterInputStream(new Data(file)));
        }

        /** Decodes the next row. */
        void next() throws IOException {
            byte[] spare = above;
            above = row;
            row = spare;
            int filter = rows.readByte();
            rows.readFully(row, 3, row.length - 3);
            for (int i = 3; i < row.length; i++) {
                int left = row[i - 3] & 0xFF;
                int up = above[i] & 0xFF;
                int corner = above[i - 3] & 0xFF;
                row[i] += (byte) switch (filter) {
                    case 0 -> 0;
                    case 1 -> left;
                    case 2 -> up;
                    case 3 -> (left + up) / 2;
                    default -> paeth(left, up, corner);
                };
            }
        }

        private static int paeth(int left, int up, int corner) {
            int estimate = left + up - corner;
            int toLeft = Math.abs(estimate - left);
            int toUp = Math.abs(estimate - up);
            int toCorner = Math.abs(estimate - corner);
            return toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
        }

        int[] colors() {
            int[] colors = new int[row.length / 3 - 1];
            for (int x = 0; x < colors.length; x++) {
                int i = 3 * x + 3;
                colors[x] = 0xFF << 24 | (row[i] & 0xFF) << 16 | (row[i + 1] & 0xFF) << 8 | row[i + 2] & 0xFF;
            }
            return colors;
        }

        @Override
        public void close() throws IOException {
            file.close();
        }
    }

    /** The data of the IDAT chunks. */
    private static final class Data extends InputStream {
        private final DataInputStream file;
        private int left;
        private boolean isInData;

        Data(DataInputStream file) {
            this.file = file;
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] bytes, int offset, int length) throws IOException {
            while (left == 0) {
                if (isInData) {
                    file.skipNBytes(4);
                }
                int size = file.readInt();
                byte[] type = new byte[4];
                file.readFully(type);
                isInData = new String(type, "US-ASCII").equals("IDAT");
                if (isInData) {
                    left = size;
                } else if (type[0] == 'I') {
                    throw new EOFException();
                } else {
                    file.skipNBytes(size + 4L);
                }
            }
            int count = file.read(bytes, offset, Math.min(length, left));
            left -= Math.max(count, 0);
            return count;
        }
    }
}
