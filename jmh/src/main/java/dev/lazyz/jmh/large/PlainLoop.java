package dev.lazyz.jmh.large;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads all numbers of a file that {@link Hills} wrote, one after the other on one thread. Returns the least one. */
final class PlainLoop {
    private static final int STL_RECORD = 50;
    private static final int STL_HEADER = 84;
    private static final int FACE = 13;
    private static final int VERTEX = 12;

    private PlainLoop() {}

    static double stl(Path file) throws IOException {
        float least = Float.POSITIVE_INFINITY;
        ByteBuffer buffer = ByteBuffer.allocate(8192 * STL_RECORD).order(ByteOrder.LITTLE_ENDIAN);
        try (InputStream input = Files.newInputStream(file)) {
            input.readNBytes(STL_HEADER);
            int count;
            while ((count = input.readNBytes(buffer.array(), 0, buffer.capacity())) > 0) {
                for (int facet = 0; facet < count; facet += STL_RECORD) {
                    for (int i = 12; i < 48; i += 4) {
                        least = Math.min(least, buffer.getFloat(facet + i));
                    }
                }
            }
        }
        return least;
    }

    static double ply(Path file) throws IOException {
        double least = Double.POSITIVE_INFINITY;
        ByteBuffer buffer = ByteBuffer.allocate(8192 * VERTEX * FACE).order(ByteOrder.LITTLE_ENDIAN);
        try (InputStream input = Files.newInputStream(file)) {
            long vertices = 0;
            StringBuilder line = new StringBuilder();
            while (!line.toString().equals("end_header")) {
                line.setLength(0);
                for (int c = input.read(); c != '\n'; c = input.read()) {
                    line.append((char) c);
                }
                if (line.indexOf("element vertex ") == 0) {
                    vertices = Long.parseLong(line.substring(15));
                }
            }
            for (long left = vertices * VERTEX; left > 0; left -= buffer.capacity()) {
                int count = input.readNBytes(buffer.array(), 0, (int) Math.min(left, buffer.capacity()));
                for (int i = 0; i < count; i += 4) {
                    least = Math.min(least, buffer.getFloat(i));
                }
            }
            int count;
            while ((count = input.readNBytes(buffer.array(), 0, buffer.capacity())) > 0) {
                for (int i = 0; i < count; i += FACE) {
                    least = Math.min(least, buffer.getInt(i + 1));
                    least = Math.min(least, buffer.getInt(i + 5));
                    least = Math.min(least, buffer.getInt(i + 9));
                }
            }
        }
        return least;
    }

    /** Decimal numbers separated by other characters; the digits after the 18th are ignored. */
    static double text(Path file) throws IOException {
        double least = Double.POSITIVE_INFINITY;
        byte[] bytes = new byte[1 << 20];
        long digits = 0;
        int decimals = -1;
        int exponent = 0;
        boolean isNegative = false;
        boolean isDown = false;
        int state = 0;
        try (InputStream input = Files.newInputStream(file)) {
            int count;
            while ((count = input.readNBytes(bytes, 0, bytes.length)) > 0) {
                for (int i = 0; i < count; i++) {
                    byte c = bytes[i];
                    if (c >= '0' && c <= '9') {
                        if (state == 2) {
                            exponent = 10 * exponent + c - '0';
                        } else {
                            digits = 10 * digits + c - '0';
                            state = 1;
                            if (decimals >= 0) {
                                decimals++;
                            }
                        }
                    } else if (c == '.') {
                        decimals = 0;
                    } else if (c == '-') {
                        isNegative |= state == 0;
                        isDown |= state == 2;
                    } else if (c == 'E' && state == 1) {
                        state = 2;
                    } else {
                        if (state > 0) {
                            int power = (isDown ? -exponent : exponent) - Math.max(decimals, 0);
                            double number = power < 0 ? digits / POWERS[-power] : digits * POWERS[power];
                            least = Math.min(least, isNegative ? -number : number);
                        }
                        digits = 0;
                        decimals = -1;
                        exponent = 0;
                        isNegative = false;
                        isDown = false;
                        state = 0;
                    }
                }
            }
        }
        return least;
    }

    private static final double[] POWERS = new double[23];

    static {
        for (int i = 0; i < POWERS.length; i++) {
            POWERS[i] = Double.parseDouble("1e" + i);
        }
    }
}
