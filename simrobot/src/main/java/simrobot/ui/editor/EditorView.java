package simrobot.ui.editor;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.SpokenComponent;
import simgsm.ui.Theme;
import simrobot.editor.Draft;
import simrobot.editor.Edits;
import simrobot.editor.Item;
import simrobot.editor.Snap;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.floor.FloorCache;
import simrobot.ui.floor.FloorPainter;
import simrobot.ui.floor.Layers;
import simrobot.ui.floor.Viewport;
import simrobot.world.Area;
import simrobot.world.Position;
import simrobot.world.World;

/** The floor that is being edited: the draft, its selected item with its handles, and what the tool is about to make. */
final class EditorView extends SpokenComponent {
    private static final double MARGIN_UNITS = 48;
    private static final double REACH_UNITS = 8;

    private final TextBundle texts;
    private final Runnable changed;
    private final FloorCache cache = new FloorCache();
    private Draft draft = new Draft(World.bare());
    private List<RobotSnapshot> robots = List.of();
    private Viewport viewport = new Viewport(0, 0, 40, 1, 1);
    private EditorTool tool = EditorTool.SELECT;
    private Snap snap = new Snap(0.1);
    private boolean fitted = true;
    private Position cursor;
    private String measure = "";

    /** @param changed run when the draft, its selection or the tool is another one */
    EditorView(TextBundle texts, Runnable changed) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.changed = changed;
        setName("editor.floor");
        setFocusable(true);
        setOpaque(true);
        EditorMouse mouse = new EditorMouse(this);
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        addFocusListener(mouse.repaintOnFocus());
        EditorKeys.install(this, mouse);
        addComponentListener(new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
                viewport = viewport.sized(getWidth(), getHeight());
                if (fitted) {
                    fit();
                }
            }
        });
    }

    // ---- what is edited --------------------------------------------------------------------------------------------

    Draft draft() {
        return draft;
    }

    /** @param standing the robots, for orientation */
    void edit(Draft newDraft, List<RobotSnapshot> standing) {
        draft = newDraft;
        robots = standing;
        fit();
        tell();
    }

    void showRobots(List<RobotSnapshot> standing) {
        robots = standing;
        repaint();
    }

    /** Something about the draft is different now. */
    void tell() {
        String before = spoken();
        changed.run();
        tellSpoken(before, spoken());
        repaint();
    }

    EditorTool tool() {
        return tool;
    }

    void take(EditorTool newTool) {
        tool = newTool;
        setCursor(Cursor.getPredefinedCursor(
                tool == EditorTool.SELECT ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        tell();
    }

    Snap snap() {
        return snap;
    }

    void snapBy(double stepMeters) {
        snap = new Snap(stepMeters);
        repaint();
    }

    /** Makes an item of the tool's kind in the middle of the view; for who has no mouse. */
    void makeInTheMiddle() {
        if (tool.kind() != null) {
            double x = snap.of(viewport.centerX());
            double y = snap.of(viewport.centerY());
            World next = EditorItems.made(draft.settled(), tool, x, y, x + 1, y + (tool == EditorTool.WALL ? 0 : 1));
            draft.change(next);
            draft.select(Edits.last(next, tool.kind()));
            tell();
        }
    }

    // ---- where one looks -------------------------------------------------------------------------------------------

    Viewport viewport() {
        return viewport;
    }

    void look(Viewport elsewhere) {
        viewport = elsewhere;
        fitted = false;
        repaint();
    }

    void zoom(double factor) {
        look(viewport.zoomedAt(getWidth() / 2.0, getHeight() / 2.0, factor));
    }

    void fit() {
        fitted = true;
        Area bounds = draft.settled().bounds();
        viewport = Viewport.fitting(bounds, getWidth(), getHeight(), Theme.exact(MARGIN_UNITS));
        repaint();
    }

    /** How far around the pointer things are meant, metres. */
    double reach() {
        return Theme.exact(REACH_UNITS) / viewport.pixelsPerMeter();
    }

    /** Where the tool would put something, and what there is to be read about it; null for nothing. */
    void point(Position at, String reading) {
        cursor = at;
        measure = reading;
        repaint();
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
            cache.paint(g, draft.still(), viewport, Layers.ALL);
            FloorPainter moving = new FloorPainter(g, viewport);
            draft.moving().ifPresent(item -> moving.item(draft.world(), item));
            EditorPainter painter = new EditorPainter(g, viewport);
            painter.raster(snap.stepMeters());
            moving.treadmills(draft.world(), 0);
            painter.robots(robots);
            draft.selected().ifPresent(item -> painter.selection(draft.world(), item));
            if (cursor != null) {
                painter.cursor(cursor, measure, tool != EditorTool.SELECT);
            }
            if (isFocusOwner()) {
                g.setColor(Theme.color(Ink.ACCENT));
                g.setStroke(Theme.stroke(1.6));
                g.draw(Drawing.round(1, 1, getWidth() - 2, getHeight() - 2, Theme.exact(4)));
            }
        } finally {
            g.dispose();
        }
    }

    @Override
    protected String spoken() {
        Optional<Item> item = draft.selected();
        String world = draft.world().name();
        return item.map(it -> texts.of("editor.spoken.item", world, EditorItems.text(texts, draft.world(), it)))
                .orElse(texts.of("editor.spoken", world));
    }
}
