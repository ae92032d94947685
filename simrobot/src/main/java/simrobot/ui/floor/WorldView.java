package simrobot.ui.floor;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JLabel;
import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.Drawing;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simrobot.drawing.Layers;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.RobotPainter;
import simrobot.drawing.Ruler;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.world.Area;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * The floor with its robots, which the mouse drags and turns. By keyboard the arrows pan; with Alt they move the
 * selected robot by 10 cm, and the Page keys turn it by 5 degrees. With the ruler the arrows move its end by 5 cm, with
 * Shift its beginning; Escape hides it.
 */
public final class WorldView extends FloorView {
    private static final double MARGIN_UNITS = 36;
    /** Units per metre below which a robot, 0.5 m across, is smaller than 8 units. */
    private static final double LEAST_SCALE = 16;

    private static final double START_SCALE = 40;
    private static final long REST_CLOCK_NANOS = 500_000_000;
    private static final double NUDGE_METERS = 0.1;
    private static final double RULER_METERS = 0.05;
    private static final double TURN_RADIANS = Math.toRadians(5);

    private final TextBundle texts;
    private final Consumer<String> selection;
    private final FloorCache floor = new FloorCache();
    private final RobotPlacing placing;
    private SimulationSnapshot scene;
    private Layers layers = Layers.ALL;
    private String selected;
    private boolean following;
    private String readout = "";
    /** Opaque, so that the floor beneath is not painted with it. */
    private final JLabel clock = Theme.label(NumberTexts.clock(0), Theme::monoSmall, Ink.QUIET);

    private PlaceListener placeListener;
    private Ruler ruler;
    private boolean live = true;

    /** Disabled without a ruler, so that the window gets the key. */
    private final transient UserAction hideRuler;

    /** Receives the place for a new robot; the heading is NaN until the mouse is dragged. */
    public interface PlaceListener {
        void at(double xMeters, double yMeters, double headingRadians);
    }

    /** @param selection receives the name of a robot selected with the mouse */
    public WorldView(SimulationSnapshot scene, TextBundle texts, OperatorActions operator, Consumer<String> selection) {
        super("world", "world", MARGIN_UNITS);
        this.scene = scene;
        this.texts = texts;
        this.selection = selection;
        placing = new RobotPlacing(operator, texts, this::repaint);
        clock.setOpaque(true);
        clock.setHorizontalAlignment(JLabel.CENTER);
        Theme.styled(clock, label -> label.setBackground(Theme.color(Ink.FLOOR)));
        add(ComponentNames.name(clock, "world.clock", texts.of("world.clock")));
        setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
        WorldMouse mouse = new WorldMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        bindArrows("pan", (dx, dy) -> arrow(dx, dy, false), 0);
        bindArrows("ruler", (dx, dy) -> arrow(dx, dy, true), InputEvent.SHIFT_DOWN_MASK);
        bindArrows("nudge", (dx, dy) -> nudge(dx, dy, 0), InputEvent.ALT_DOWN_MASK);
        bind("turn.left", () -> nudge(0, 0, TURN_RADIANS), InputEvent.ALT_DOWN_MASK, KeyEvent.VK_PAGE_UP);
        bind("turn.right", () -> nudge(0, 0, -TURN_RADIANS), InputEvent.ALT_DOWN_MASK, KeyEvent.VK_PAGE_DOWN);
        hideRuler = bind("letGo", () -> measure(null), 0, KeyEvent.VK_ESCAPE);
        hideRuler.setEnabled(false);
    }

    private void arrow(int dx, int dy, boolean begin) {
        if (ruler == null) {
            pan(dx, dy);
        } else {
            measure(ruler.movedBy(begin, dx * RULER_METERS, dy * RULER_METERS));
        }
    }

    /** Moves the selected robot by steps of 10 cm and turns it. */
    public void nudge(int dx, int dy, double turnRadians) {
        selectedRobot()
                .filter(robot -> live)
                .ifPresent(robot -> placing.put(
                        robot,
                        robot.xMeters() + dx * NUDGE_METERS,
                        robot.yMeters() + dy * NUDGE_METERS,
                        robot.headingRadians() + turnRadians));
    }

    // ---- what is shown ---------------------------------------------------------------------------------------------

    public void show(SimulationSnapshot newest) {
        World before = scene.world();
        boolean still = SnapshotComparison.looksTheSame(scene, newest);
        // At rest a running clock is shown once a second, so its hundredths say nothing.
        String exact = NumberTexts.clock(newest.timeNanos());
        boolean isRunningAtRest = still && newest.timeNanos() - scene.timeNanos() > REST_CLOCK_NANOS;
        clock.setText(isRunningAtRest ? exact.substring(0, exact.indexOf('.')) : exact);
        change(() -> scene = newest);
        if (newest.world() != before) {
            showStart();
        }
        follow();
        if (!still) {
            repaint();
        }
    }

    @Override
    protected Area floorArea() {
        return scene.world().bounds();
    }

    /** The area around one robot, if robots would be too small in the whole floor. */
    @Override
    protected Viewport start(Viewport whole) {
        if (whole.pixelsPerMeter() >= Theme.exact(LEAST_SCALE)) {
            return whole;
        }
        return selectedRobot()
                .or(() -> scene.robots().stream().findFirst())
                .map(robot -> new Viewport(
                        robot.xMeters(), robot.yMeters(), Theme.exact(START_SCALE), whole.width(), whole.height()))
                .orElse(whole);
    }

    SimulationSnapshot scene() {
        return scene;
    }

    public void select(String robot) {
        if (!Objects.equals(selected, robot)) {
            boolean isFirst = selected == null;
            selected = robot;
            if (isFirst && isAtStart()) {
                showStart();
            }
            repaint();
        }
    }

    public Optional<RobotSnapshot> selectedRobot() {
        return scene.robots().stream()
                .filter(robot -> robot.name().equals(selected))
                .findFirst();
    }

    /** Selects a robot in the whole window, possibly once it is added. */
    public void requestSelection(String robot) {
        selection.accept(robot);
    }

    public Layers layers() {
        return layers;
    }

    public void setLayers(Layers newLayers) {
        layers = newLayers;
        repaint();
    }

    public boolean isFollowing() {
        return following;
    }

    /** Keeps the selected robot in the centre. */
    public void setFollowing(boolean follow) {
        following = follow;
        if (follow) {
            look(viewport());
        }
        follow();
    }

    private void follow() {
        if (following) {
            selectedRobot()
                    .filter(robot -> robot.xMeters() != viewport().centerX()
                            || robot.yMeters() != viewport().centerY())
                    .ifPresent(robot -> look(viewport().centeredOn(robot.xMeters(), robot.yMeters())));
        }
    }

    /** Shows the position under the pointer at the lower right; empty for none. */
    void setReadout(String text) {
        if (!text.equals(readout)) {
            readout = text;
            repaint();
        }
    }

    // ---- placing robots --------------------------------------------------------------------------------------------

    public RobotPlacing placing() {
        return placing;
    }

    /** Disables moving robots for recordings. */
    public void setLive(boolean nowLive) {
        live = nowLive;
    }

    boolean isLive() {
        return live;
    }

    /**
     * Passes the next place pressed on the floor to the listener only.
     *
     * @param listener or null
     */
    public void choosePlace(PlaceListener listener) {
        placeListener = listener;
        placing.show(null);
    }

    Optional<PlaceListener> placeListener() {
        return Optional.ofNullable(placeListener);
    }

    // ---- ruler -----------------------------------------------------------------------------------------------------

    /** Null while it is hidden. */
    public Ruler ruler() {
        return ruler;
    }

    /** @param newRuler null hides the ruler */
    void measure(Ruler newRuler) {
        change(() -> ruler = newRuler);
        hideRuler.setEnabled(newRuler != null);
        repaint();
    }

    /** Shows the ruler from the selected robot, or from the view's centre, to 1 m ahead; or hides it. */
    public void toggleRuler() {
        if (ruler != null) {
            measure(null);
            return;
        }
        Position from = selectedRobot()
                .filter(robot -> viewport().shows(robot.xMeters(), robot.yMeters(), 0))
                .map(robot -> new Position(robot.xMeters(), robot.yMeters()))
                .orElse(new Position(viewport().centerX(), viewport().centerY()));
        double heading = selectedRobot().map(RobotSnapshot::headingRadians).orElse(0.0);
        measure(new Ruler(from, new Position(from.xMeters() + Math.cos(heading), from.yMeters() + Math.sin(heading))));
        requestFocusInWindow();
    }

    @Override
    public void doLayout() {
        int width = Drawing.width(clock.getFont(), NumberTexts.clock(0)) + Theme.px(16);
        clock.setBounds(getWidth() - width - Theme.px(10), Theme.px(12), width, Theme.px(20));
    }

    /** Another time on the clock lays out nothing around the floor. */
    @Override
    public boolean isValidateRoot() {
        return true;
    }

    // ---- painting --------------------------------------------------------------------------------------------------

    @Override
    protected void paint(Graphics2D graphics, double width, double height) {
        floor.paint(graphics, scene.world(), viewport(), layers);
        Canvas g = new GraphicsCanvas(graphics);
        WorldPainter.robots(g, scene, viewport(), layers, selected);
        placing.preview().ifPresent(preview -> new RobotPainter(g, viewport()).preview(preview));
        if (ruler != null) {
            ruler.paint(g, viewport());
        }
        if (!readout.isEmpty()) {
            tag(g, readout, width, height - g.px(30));
        }
    }

    /** Draws a small text at the right edge. */
    private static void tag(Canvas g, String text, double right, double top) {
        double width = g.width(text, Face.MONO_SMALL) + g.px(16);
        double x = right - width - g.px(10);
        WorldPainter.textGround(g, Ink.FLOOR, 0.85, x, top, width, g.px(20));
        g.ink(Ink.QUIET);
        g.text(text, Face.MONO_SMALL, x + width / 2, top + g.px(10));
    }

    @Override
    protected String spoken() {
        if (ruler != null) {
            return texts.of("world.spoken.ruler", ruler.text());
        }
        return selectedRobot()
                .map(robot -> texts.of(
                        "world.spoken",
                        scene.world().name(),
                        robot.name(),
                        NumberTexts.meters(robot.xMeters()),
                        NumberTexts.meters(robot.yMeters()),
                        NumberTexts.degrees(robot.headingRadians())))
                .orElse(texts.of("world.spoken.empty", scene.world().name()));
    }
}
