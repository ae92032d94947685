package simrobot.ui.inspector;

import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.util.concurrent.ExecutorService;
import javax.accessibility.AccessibleRole;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.thread.DaemonThread;
import simgsm.ui.Drawing;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simrobot.camera.Camera;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import vericommand.RobotStatus;

/**
 * The image of the selected robot's camera, drawn on a separate thread at most 15 times a second, only while the view
 * is visible and after a robot has moved.
 */
public final class CameraView extends PaintedComponent {
    private static final int PERIOD_MILLIS = 66;
    private static final double LEAST_SHARE = 0.6;

    private final TextBundle texts;
    private final Timer timer = new Timer(PERIOD_MILLIS, tick -> draw());
    private final Camera camera = new Camera();
    private ExecutorService executor;
    private CameraScene newest;
    private CameraScene drawn;
    private boolean drawing;
    private BufferedImage picture;

    /** A robot in a scene. */
    private record CameraScene(SimulationSnapshot scene, RobotSnapshot robot) {
        /** True if world and robots have the same positions. */
        boolean looksLike(CameraScene other) {
            return other != null
                    && robot.name().equals(other.robot.name())
                    && robot.powered() == other.robot.powered()
                    && scene.world() == other.scene.world()
                    && scene.hasRobotsAs(other.scene, RobotSnapshot::isAtPoseOf);
        }
    }

    public CameraView(TextBundle texts) {
        super(AccessibleRole.LABEL);
        setName("camera");
        this.texts = texts;
        timer.setRepeats(false);
    }

    /** Called with each new snapshot, on the event thread. */
    public void show(SimulationSnapshot scene, RobotSnapshot robot) {
        change(() -> newest = new CameraScene(scene, robot));
        drawSoon();
    }

    private void drawSoon() {
        if (executor != null && newest != null && !newest.looksLike(drawn)) {
            timer.start();
        }
    }

    @Override
    protected String spoken() {
        String missing = missing();
        return missing.isEmpty() ? texts.of("camera.spoken", newest.robot().name()) : missing;
    }

    /** The reason for a missing image; may be empty. */
    private String missing() {
        if (newest == null) {
            return texts.of("camera.none");
        }
        if (!newest.robot().simulated()) {
            return texts.of("camera.real");
        }
        return newest.robot().status() == RobotStatus.DISCONNECTED ? texts.of("camera.off") : "";
    }

    /** Draws the newest picture on the calling thread; for tests. */
    void drawNow() {
        if (newest != null) {
            drawn = newest;
            picture = camera.picture(drawn.scene(), drawn.robot());
        }
    }

    private void draw() {
        if (drawing || !missing().isEmpty() || !isShowing() || getVisibleRect().isEmpty() || newest.looksLike(drawn)) {
            return;
        }
        CameraScene sight = newest;
        drawing = true;
        executor.execute(() -> {
            BufferedImage seen = camera.picture(sight.scene(), sight.robot());
            SwingUtilities.invokeLater(() -> {
                drawing = false;
                drawn = sight;
                picture = seen;
                repaint();
                drawSoon();
            });
        });
    }

    @Override
    public void addNotify() {
        super.addNotify();
        drawing = false;
        executor = DaemonThread.executor("camera");
    }

    @Override
    public void removeNotify() {
        timer.stop();
        if (executor != null) {
            executor.shutdown();
        }
        super.removeNotify();
    }

    @Override
    public Dimension getPreferredSize() {
        int width = Theme.px(Camera.WIDTH * LEAST_SHARE);
        return new Dimension(width, width * Camera.HEIGHT / Camera.WIDTH);
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        drawSoon();
        double share = Math.min(width / Camera.WIDTH, height / Camera.HEIGHT);
        double w = Camera.WIDTH * share;
        double h = Camera.HEIGHT * share;
        double x = (width - w) / 2;
        double y = (height - h) / 2;
        double round = Theme.exact(6);
        g.setColor(Theme.color(Ink.LINE));
        g.fill(new RoundRectangle2D.Double(x, y, w, h, round, round));
        String missing = missing();
        if (picture != null && missing.isEmpty()) {
            g.clip(new RoundRectangle2D.Double(x, y, w, h, round, round));
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BICUBIC);
            g.drawImage(picture, new AffineTransform(share, 0, 0, share, x, y), null);
        } else {
            g.setFont(Theme.base());
            g.setColor(Theme.color(Ink.QUIET));
            float left = (float) (x + (w - Drawing.width(Theme.base(), missing)) / 2);
            g.drawString(missing, left, (float) (y + h / 2));
        }
    }
}
