package example;

import static dev.lazyz.scenes.pictures.PictureParameters.AZIMUTH;
import static dev.lazyz.scenes.pictures.PictureParameters.BACKGROUND;
import static dev.lazyz.scenes.pictures.PictureParameters.ELEVATION;
import static dev.lazyz.scenes.pictures.PictureParameters.LIGHT;
import static dev.lazyz.scenes.pictures.PictureParameters.LIGHT_INTENSITY;
import static dev.lazyz.scenes.pictures.PictureParameters.STYLE;

import dev.lazyz.Image;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.Frame.SeenPoint;
import dev.lazyz.lighting.LightRig;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.Backdrop;
import dev.lazyz.scenes.pictures.PictureFrame;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.pictures.PictureStyle;
import dev.lazyz.scenes.pictures.Turntable;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Collectors;

/** The steps of the guide "Lazy Z from Java in ten minutes". */
public final class TenMinutes {
    private TenMinutes() {}

    static Image firstPicture(Path file, Path picture) throws IOException, InterruptedException {
        LoadedScene model = Scenes.load(file);
        model.getWarnings().forEach(System.err::println);
        Image image = new PictureSettings(640, 480).frame(model).render(new TiledRenderer());
        Images.writePng(image, picture);
        return image;
    }

    static LoadedScene painted(LoadedScene model, String part, Rgba color) {
        Scene scene = model.getScene();
        return model.withScene(scene.withSurfaces(scene.getSurfaces().stream()
                .map(surface -> surface.getName().endsWith(part)
                        ? surface.withMaterials(material -> material.withBaseColor(color))
                        : surface)
                .collect(Collectors.toList())));
    }

    static List<PictureSettings> lights() {
        PictureSettings plain = new PictureSettings(640, 480);
        PictureSettings sunny = plain.with(LIGHT, LightRig.SUN).with(LIGHT_INTENSITY, 1.5);
        PictureSettings fromAbove = sunny.with(AZIMUTH, 45.0).with(ELEVATION, 60.0);
        PictureSettings product = plain.with(STYLE, PictureStyle.PRODUCT);
        return List.of(plain, sunny, fromAbove, product);
    }

    static BufferedImage thumbnail(Path file) throws IOException, InterruptedException {
        PictureSettings small = new PictureSettings(128, 128).with(BACKGROUND, new Backdrop(Rgba.TRANSPARENT));
        return Images.toBufferedImage(small.frame(Scenes.load(file)).render(new TiledRenderer()));
    }

    static String pick(LoadedScene model, int x, int y) throws InterruptedException {
        PictureFrame frame = new PictureSettings(640, 480).frame(model);
        SeenPoint point = frame.getSamples().at(x, y);
        return point == null ? null : point.getPart();
    }

    static List<BufferedImage> turn(LoadedScene model, int steps) throws InterruptedException, ExecutionException {
        Turntable turntable = new PictureSettings(320, 240).turntable(model, steps);

        // Many pictures at the same time, each by one thread, are faster than one after the other by all threads
        RenderOptions one = new RenderOptions().withThreads(1);
        Renderer renderer = new TiledRenderer(one);
        List<Callable<BufferedImage>> tasks = new ArrayList<>();
        for (int i = 0; i < steps; i++) {
            int step = i;
            tasks.add(() -> Images.toBufferedImage(turntable.frame(step, one).render(renderer)));
        }
        ExecutorService workers = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
        try {
            List<BufferedImage> pictures = new ArrayList<>();
            for (Future<BufferedImage> picture : workers.invokeAll(tasks)) {
                pictures.add(picture.get());
            }
            return pictures;
        } finally {
            workers.shutdownNow();
        }
    }
}
