package dev.lazyz.jmh.large;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/** Reads the files of {@link Hills} in a plain loop over their numbers. The results prove that all were read. */
final class PlainLoops {
    private static final int STL_RECORD = 50;
    private static final int STL_HEADER = 84;
    private static final int VERTEX = 12;
    private static final int FACE = 13;
    private static final int ROWS = 1 << 15;

    private PlainLoops() {}

    static String stl(InputStream input) throws IOException {
        float least = Float.POSITIVE_INFINITY;
        ByteBuffer buffer = buffer(8192 * STL_RECORD);
        input.readNBytes(STL_HEADER);
        int count;
        while ((count = input.readNBytes(buffer.array(), 0, buffer.capacity())) > 0) {
            for (int facet = 0; facet < count; facet += STL_RECORD) {
                for (int i = 12; i < 48; i += 4) {
                    least = Math.min(least, buffer.getFloat(facet + i));
                }
            }
        }
        return "least coordinate " + least;
    }

    static String ply(InputStream input) throws IOException {
        StringBuilder header = new StringBuilder();
        while (header.indexOf("end_header\n") < 0) {
            header.append((char) input.read());
        }
        long vertices = Long.parseLong(header.toString().replaceAll("(?s).*element vertex (\\d+).*", "$1"));
        float least = Float.POSITIVE_INFINITY;
        ByteBuffer buffer = buffer(ROWS * VERTEX);
        for (long left = vertices; left > 0; left -= ROWS) {
            int count = input.readNBytes(buffer.array(), 0, (int) Math.min(left, ROWS) * VERTEX);
            for (int at = 0; at < count; at += 4) {
                least = Math.min(least, buffer.getFloat(at));
            }
        }
        int greatest = 0;
        ByteBuffer faces = buffer(ROWS * FACE);
        int count;
        while ((count = input.readNBytes(faces.array(), 0, faces.capacity())) > 0) {
            for (int at = 0; at < count; at += FACE) {
                greatest = Math.max(greatest, Math.max(faces.getInt(at + 1), faces.getInt(at + 5)));
                greatest = Math.max(greatest, faces.getInt(at + 9));
            }
        }
        return "least coordinate " + least + ", greatest number " + greatest;
    }

    /** Parses each word that begins with a digit or a sign. */
    static String obj(InputStream input) throws IOException {
        double least = Double.POSITIVE_INFINITY;
        double greatest = 0;
        byte[] bytes = new byte[1 << 20];
        boolean isWord = false;
        boolean isNegative = false;
        int power = 0;
        int decimals = -1;
        boolean isDownward = false;
        long digits = 0;
        int count;
        while ((count = input.read(bytes)) > 0) {
            for (int at = 0; at < count; at++) {
                byte c = bytes[at];
                if (c >= '0' && c <= '9') {
                    isWord = true;
                    if (isDownward) {
                        power = 10 * power + c - '0';
                    } else {
                        digits = 10 * digits + c - '0';
                        decimals += decimals >= 0 ? 1 : 0;
                    }
                } else if (c == '.') {
                    decimals = 0;
                } else if (c == 'E') {
                    isDownward = true;
                } else if (c == '-') {
                    isNegative = isNegative || !isWord;
                } else if (isWord) {
                    double number = digits / Math.pow(10, Math.max(decimals, 0) + power);
                    least = Math.min(least, isNegative ? -number : number);
                    greatest = Math.max(greatest, number);
                    isWord = false;
                    isNegative = false;
                    isDownward = false;
                    power = 0;
                    decimals = -1;
                    digits = 0;
                }
            }
        }
        return "least coordinate " + (float) least + ", greatest number " + (long) greatest;
    }

    private static ByteBuffer buffer(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
