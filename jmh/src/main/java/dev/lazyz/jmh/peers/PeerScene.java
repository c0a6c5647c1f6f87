package dev.lazyz.jmh.peers;

/**
 * A picture that renderers are compared on.
 *
 * @param scene name of the scene or mesh file, without a folder
 * @param side width and height of the raster, pixels
 * @param samples a pixel has the square of this number of samples
 * @param threads number of threads of the renderer; the process has as many processors
 */
record PeerScene(String scene, int side, int samples, int threads) {
    /** Returns the subject whose text is {@code text}. */
    static PeerScene parse(String text) {
        String[] parts = text.split("; ");
        return new PeerScene(parts[0], number(parts[1]), number(parts[2]), number(parts[3]));
    }

    private static int number(String words) {
        return Integer.parseInt(words.substring(0, words.indexOf(' ')));
    }

    @Override
    public String toString() {
        return String.format("%s; %d pixels; %d x %d samples; %d threads", scene, side, samples, samples, threads);
    }
}
