package example;

import dev.lazyz.Renderer;
import dev.lazyz.SeenPoint;
import dev.lazyz.filter.SampledFrame;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.pictures.PictureFrame;
import dev.lazyz.scenes.pictures.PictureParameters;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.writers.BufferedImages;
import dev.lazyz.strategies.tiled.TiledRenderer;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.SwingWorker;

/** A model in a window: dragging turns it, and a click tells the name of the part under the mouse. */
public final class ModelPanel extends JPanel {
    private record View(BufferedImage picture, SampledFrame samples) {}

    private final transient LoadedScene model;
    private final transient Renderer renderer = new TiledRenderer();
    private transient SwingWorker<View, Void> work;
    private transient View view;
    private double azimuth = 30;
    private double elevation = 20;

    public ModelPanel(LoadedScene model, Consumer<String> clicked) {
        this.model = model;
        MouseAdapter mouse = new MouseAdapter() {
            private Point last = new Point();

            @Override
            public void mousePressed(MouseEvent event) {
                last = event.getPoint();
            }

            @Override
            public void mouseDragged(MouseEvent event) {
                azimuth -= event.getX() - last.x;
                elevation = Math.max(-90, Math.min(90, elevation + event.getY() - last.y));
                last = event.getPoint();
                draw();
            }

            @Override
            public void mouseClicked(MouseEvent event) {
                if (view == null || !view.samples.getPixels().contains(event.getX(), event.getY())) return;
                try {
                    SeenPoint point = view.samples.at(event.getX(), event.getY());
                    if (point != null) clicked.accept(point.getPart());
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                draw();
            }
        });
    }

    /** Renders in the background. A rendering that is in progress is interrupted. */
    private void draw() {
        if (work != null) work.cancel(true);
        PictureSettings settings = new PictureSettings(Math.max(getWidth(), 1), Math.max(getHeight(), 1))
                .with(PictureParameters.AZIMUTH, azimuth)
                .with(PictureParameters.ELEVATION, elevation);
        work = new SwingWorker<>() {
            @Override
            protected View doInBackground() throws Exception {
                PictureFrame frame = settings.frame(model);
                return new View(BufferedImages.toBufferedImage(frame.render(renderer)), frame.getSamples());
            }

            @Override
            protected void done() {
                if (isCancelled()) return;
                try {
                    view = get();
                    repaint();
                } catch (InterruptedException | ExecutionException e) {
                    throw new IllegalStateException(e);
                }
            }
        };
        work.execute();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (view != null) graphics.drawImage(view.picture, 0, 0, null);
    }
}
