package simrobot.ui.floor;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.SpokenComponent;
import simgsm.ui.Theme;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.ui.OperatorActions;
import simrobot.ui.PoseTexts;
import simrobot.world.Area;
import simrobot.world.Position;
import simrobot.world.World;

/** The floor with its robots: zoom, pan, follow, and robots that can be dragged and turned. */
public final class WorldView extends SpokenComponent {
    private static final double MARGIN_UNITS = 36;

    private final TextBundle texts;
    private final OperatorActions operator;
    private final Consumer<String> selection;
    private final FloorCache floor = new FloorCache();
    private SimulationSnapshot picture;
    private Viewport viewport = new Viewport(0, 0, 40, 1, 1);
    private Layers layers = Layers.ALL;
    private String selected;
    private boolean fitted = true;
    private boolean following;
    private String readout = "";
    private final RobotPlacing hand;
    private PlaceWish placeWish;
    private Ruler ruler;
    private boolean live = true;

    /** Who wants to know where on the floor a robot is to go; the heading is NaN while it was not shown. */
    public interface PlaceWish {
        void at(double xMeters, double yMeters, double headingRadians);
    }

    /** @param selection told when a robot is picked with the mouse */
    public WorldView(
            SimulationSnapshot picture, TextBundle texts, OperatorActions operator, Consumer<String> selection) {
        super(AccessibleRole.CANVAS);
        this.picture = picture;
        this.texts = texts;
        this.operator = operator;
        this.selection = selection;
        hand = new RobotPlacing(operator, texts, this::repaint);
        setName("world");
        setFocusable(true);
        setOpaque(true);
        setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
        WorldMouse mouse = new WorldMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addFocusListener(mouse.repaintOnFocus());
        WorldKeys.install(this);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                resized();
            }
        });
    }

    // ---- what is shown ---------------------------------------------------------------------------------------------

    public void show(SimulationSnapshot newest) {
        World before = picture.world();
        String spoken = spoken();
        boolean still = SnapshotComparison.between(picture, newest);
        picture = newest;
        if (newest.world() != before) {
            fit();
        }
        follow();
        tellSpoken(spoken, spoken());
        if (still) {
            repaint(getWidth() - Theme.px(120), 0, Theme.px(120), Theme.px(40));
        } else {
            repaint();
        }
    }

    public void select(String robot) {
        if (!Objects.equals(selected, robot)) {
            selected = robot;
            repaint();
        }
    }

    public Optional<RobotSnapshot> selectedRobot() {
        return picture.robots().stream()
                .filter(robot -> robot.name().equals(selected))
                .findFirst();
    }

    public Layers layers() {
        return layers;
    }

    public void setLayers(Layers newLayers) {
        layers = newLayers;
        repaint();
    }

    // ---- where one looks -------------------------------------------------------------------------------------------

    public Viewport viewport() {
        return viewport;
    }

    /** Looks elsewhere by hand: the view no longer fits itself, nor follows. */
    void look(Viewport elsewhere) {
        viewport = elsewhere;
        fitted = false;
        repaint();
    }

    /** Shows the whole world, also when the view's size changes. */
    public void fit() {
        fitted = true;
        Area bounds = picture.world().bounds();
        viewport = Viewport.fitting(bounds, getWidth(), getHeight(), Theme.exact(MARGIN_UNITS));
        repaint();
    }

    public void zoom(double factor) {
        look(viewport.zoomedAt(getWidth() / 2.0, getHeight() / 2.0, factor));
    }

    public boolean isFollowing() {
        return following;
    }

    /** Keeps the selected robot in the middle. */
    public void setFollowing(boolean follow) {
        following = follow;
        if (follow) {
            fitted = false;
        }
        follow();
    }

    private void follow() {
        if (following) {
            selectedRobot()
                    .filter(robot -> robot.xMeters() != viewport.centerX() || robot.yMeters() != viewport.centerY())
                    .ifPresent(robot -> look(viewport.centeredOn(robot.xMeters(), robot.yMeters())));
        }
    }

    private void resized() {
        viewport = viewport.sized(getWidth(), getHeight());
        if (fitted) {
            fit();
        }
    }

    /** The place under the pointer, in the corner; empty for none. */
    void setReadout(String text) {
        if (!text.equals(readout)) {
            readout = text;
            repaint();
        }
    }

    // ---- acts ------------------------------------------------------------------------------------------------------

    public RobotPlacing hand() {
        return hand;
    }

    // ---- ruler -----------------------------------------------------------------------------------------------------

    /** Null while nothing is measured. */
    public Ruler ruler() {
        return ruler;
    }

    void measure(Ruler newRuler) {
        String before = spoken();
        ruler = newRuler;
        tellSpoken(before, spoken());
        repaint();
    }

    /** Lays the ruler down a metre ahead of the selected robot, or in the middle; or takes it away. */
    public void toggleRuler() {
        if (ruler != null) {
            measure(null);
            return;
        }
        Position from = selectedRobot()
                .filter(robot -> viewport.shows(robot.xMeters(), robot.yMeters(), 0))
                .map(robot -> new Position(robot.xMeters(), robot.yMeters()))
                .orElse(new Position(viewport.centerX(), viewport.centerY()));
        double heading = selectedRobot().map(RobotSnapshot::headingRadians).orElse(0.0);
        measure(new Ruler(from, new Position(from.xMeters() + Math.cos(heading), from.yMeters() + Math.sin(heading))));
        requestFocusInWindow();
    }

    // ---- places ----------------------------------------------------------------------------------------------------

    /** Until it is taken back with null, the floor is asked for a place. */
    public void askForPlace(PlaceWish wish) {
        placeWish = wish;
        hand.show(null);
    }

    boolean isAskingForPlace() {
        return placeWish != null;
    }

    /** Robots of a recording cannot be taken. */
    public void setLive(boolean nowLive) {
        live = nowLive;
    }

    boolean isLive() {
        return live;
    }

    void namePlace(double xMeters, double yMeters, double headingRadians) {
        placeWish.at(xMeters, yMeters, headingRadians);
    }

    /** To 5 cm. */
    double snapped(double meters) {
        return Math.rint(meters * 20) / 20;
    }

    SimulationSnapshot picture() {
        return picture;
    }

    TextBundle texts() {
        return texts;
    }

    void pick(RobotSnapshot robot) {
        selection.accept(robot.name());
    }

    /** A robot that is not in the picture yet is to be selected when it comes. */
    public void wish(String robot) {
        selection.accept(robot);
    }

    /** Moves the selected robot by hand. */
    public void nudge(double dxMeters, double dyMeters, double turnRadians) {
        selectedRobot()
                .filter(robot -> live)
                .ifPresent(robot -> hand.put(
                        robot,
                        robot.xMeters() + dxMeters,
                        robot.yMeters() + dyMeters,
                        robot.headingRadians() + turnRadians));
    }

    // ---- painting --------------------------------------------------------------------------------------------------

    @Override
    public Dimension getPreferredSize() {
        return isPreferredSizeSet() ? super.getPreferredSize() : new Dimension(Theme.px(720), Theme.px(460));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(200), Theme.px(160));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = Drawing.on(graphics);
        try {
            floor.paint(g, picture.world(), viewport, layers);
            WorldPainter.robots(g, picture, viewport, layers, selected);
            hand.ghost().ifPresent(ghost -> new RobotPainter(g, viewport).ghost(ghost));
            if (ruler != null) {
                ruler.paint(g, viewport);
            }
            clock(g);
            place(g);
            if (isFocusOwner()) {
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.stroke(1.6));
                g.draw(Drawing.round(1, 1, getWidth() - 2, getHeight() - 2, Theme.exact(4)));
            }
        } finally {
            g.dispose();
        }
    }

    private void clock(Graphics2D g) {
        tag(g, clockText(picture.timeNanos()), Theme.exact(12));
    }

    public static String clockText(long nanos) {
        long centis = nanos / 10_000_000;
        return "%d:%02d:%02d.%02d".formatted(centis / 360_000, centis / 6000 % 60, centis / 100 % 60, centis % 100);
    }

    private void place(Graphics2D g) {
        if (!readout.isEmpty()) {
            tag(g, readout, getHeight() - Theme.exact(30));
        }
    }

    /** A small text on a see-through ground at the right edge. */
    private void tag(Graphics2D g, String text, double top) {
        double width = Drawing.width(Theme.monoSmall(), text) + Theme.exact(16);
        double x = getWidth() - width - Theme.exact(10);
        g.setColor(Theme.color(Ink.FLOOR, 0.85));
        g.fill(Drawing.round(x, top, width, Theme.exact(20), Theme.exact(Theme.CONTROL_RADIUS)));
        g.setColor(Theme.color(Ink.QUIET));
        Drawing.centred(g, text, Theme.monoSmall(), x + width / 2, top + Theme.exact(10));
    }

    // ---- accessibility ---------------------------------------------------------------------------------------------

    @Override
    protected String spoken() {
        if (ruler != null) {
            return texts.of("world.spoken.ruler", ruler.text());
        }
        return selectedRobot()
                .map(robot -> texts.of(
                        "world.spoken",
                        picture.world().name(),
                        robot.name(),
                        PoseTexts.meters(robot.xMeters()),
                        PoseTexts.meters(robot.yMeters()),
                        PoseTexts.degrees(robot.headingRadians())))
                .orElse(texts.of("world.spoken.empty", picture.world().name()));
    }
}
