package simrobot.ui.editor;

import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.ui.GraphicsCanvas;
import simrobot.drawing.FloorPainter;
import simrobot.drawing.Layers;
import simrobot.editor.Draft;
import simrobot.editor.Edits;
import simrobot.editor.Handle;
import simrobot.editor.Snap;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.floor.FloorCache;
import simrobot.ui.floor.FloorView;
import simrobot.world.Area;
import simrobot.world.Home;
import simrobot.world.ItemKind;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * The edited floor: the draft, its selected item with its handles, and the tool's position. By keyboard the arrows move
 * the selected item by a step of the raster, or pan; with Shift they move its end, its corner or its heading; Insert
 * makes an item in the centre; Delete deletes; Escape ends a drag, else the selection and the tool.
 */
final class EditorView extends FloorView {
    private static final double MARGIN_UNITS = 48;
    private static final double REACH_UNITS = 8;
    private static final double STEP_WITHOUT_RASTER_METERS = 0.01;

    private final TextBundle texts;
    private final Runnable changed;
    private final FloorCache cache = new FloorCache();
    private final EditorMouse mouse = new EditorMouse(this);
    private Draft draft = new Draft(World.bare());
    private List<RobotSnapshot> robots = List.of();
    private EditorTool tool = EditorTool.SELECT;
    private Snap snap = new Snap(0.1);
    private Position pointer;
    private String measure = "";
    private World looked;
    private List<Home> blocked = List.of();

    /** @param changed run when the draft, its selection or the tool has changed */
    EditorView(TextBundle texts, Runnable changed) {
        super("editor.floor", "editor", MARGIN_UNITS);
        this.texts = texts;
        this.changed = changed;
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        bindArrows("arrow", this::arrow, 0);
        bindArrows("pull", this::pull, InputEvent.SHIFT_DOWN_MASK);
        bindArrows("pan", this::pan, InputEvent.CTRL_DOWN_MASK);
        bind("insert", this::makeInTheCentre, 0, KeyEvent.VK_INSERT, KeyEvent.VK_ENTER);
        bind("erase", () -> step(draft::deleteSelected), 0, KeyEvent.VK_DELETE, KeyEvent.VK_BACK_SPACE);
        bind("letGo", this::escape, 0, KeyEvent.VK_ESCAPE);
    }

    // ---- what is edited --------------------------------------------------------------------------------------------

    Draft draft() {
        return draft;
    }

    /** @param newRobots shown as circles, for orientation */
    void edit(Draft newDraft, List<RobotSnapshot> newRobots) {
        draft = newDraft;
        robots = newRobots;
        fit();
        fireChanged();
    }

    @Override
    protected Area floorArea() {
        return draft.committed().bounds();
    }

    void showRobots(List<RobotSnapshot> newRobots) {
        robots = newRobots;
        repaint();
    }

    /** Called after a change of the draft, its selection or the tool. */
    void fireChanged() {
        change(changed);
        repaint();
    }

    void step(Runnable change) {
        change.run();
        fireChanged();
    }

    /** The homes at which no robot fits; computed once for each change. */
    List<Home> blockedHomes() {
        World committed = draft.committed();
        if (committed != looked) {
            looked = committed;
            blocked = Edits.blockedHomes(committed, Pioneer2Dx.RADIUS_METERS);
        }
        return blocked;
    }

    EditorTool tool() {
        return tool;
    }

    void setTool(EditorTool newTool) {
        mouse.cancel();
        tool = newTool;
        setCursor(Cursor.getPredefinedCursor(
                tool == EditorTool.SELECT ? Cursor.DEFAULT_CURSOR : Cursor.CROSSHAIR_CURSOR));
        fireChanged();
    }

    Snap snap() {
        return snap;
    }

    /** @param stepMeters of the raster, 0 for none */
    void setRaster(double stepMeters) {
        snap = new Snap(stepMeters);
        repaint();
    }

    /** Maximum distance of the pointer from a selected item, metres. */
    double reach() {
        return meters(REACH_UNITS);
    }

    // ---- keys ------------------------------------------------------------------------------------------------------

    /** Makes an item of the tool's kind in the centre of the view. */
    private void makeInTheCentre() {
        if (tool.kind() != null) {
            double x = snap.of(viewport().centerX());
            double y = snap.of(viewport().centerY());
            Position to = new Position(x + 1, y + (tool.draws(ItemKind.Shape.LINE) ? 0 : 1));
            World next = Edits.with(draft.committed(), tool.kind().drawn(draft.committed(), new Position(x, y), to));
            draft.change(next);
            draft.select(Edits.last(next, tool.kind()));
            fireChanged();
        }
    }

    private void arrow(int dx, int dy) {
        draft.selected()
                .ifPresentOrElse(
                        item -> {
                            double step = step();
                            draft.change(Edits.moved(draft.committed(), item, dx * step, dy * step));
                            fireChanged();
                        },
                        () -> pan(dx, dy));
    }

    private double step() {
        return snap.stepMeters() == 0 ? STEP_WITHOUT_RASTER_METERS : snap.stepMeters();
    }

    /** Moves the end of a wall, the upper right corner of an area, or a home's heading. */
    private void pull(int dx, int dy) {
        draft.selected().ifPresent(item -> {
            List<Handle> handles = Edits.handles(draft.committed(), item);
            Handle handle = handles.get(handles.size() / 2);
            double x = handle.place().xMeters() + dx * step();
            double y = handle.place().yMeters() + dy * step();
            draft.change(Edits.pulled(draft.committed(), handle, x, y));
            fireChanged();
        });
    }

    private void escape() {
        if (!mouse.cancel()) {
            draft.select(null);
            setTool(EditorTool.SELECT);
        }
        fireChanged();
    }

    // ---- painting --------------------------------------------------------------------------------------------------

    /**
     * @param at the tool's position, null for none;
     * @param reading shown there
     */
    void point(Position at, String reading) {
        pointer = at;
        measure = reading;
        repaint();
    }

    @Override
    protected void paint(Graphics2D graphics, double width, double height) {
        cache.paint(graphics, draft.background(), viewport(), Layers.ALL);
        Canvas g = new GraphicsCanvas(graphics);
        EditorPainter painter = new EditorPainter(g, viewport());
        draft.moving().ifPresent(item -> painter.item(Edits.get(draft.world(), item)));
        painter.raster(snap.stepMeters());
        FloorPainter floor = new FloorPainter(g, viewport());
        floor.surfaces(draft.world(), 0);
        floor.homeNames(draft.world(), List.of());
        painter.blocked(blockedHomes().stream()
                .filter(draft.world().items(Home.class)::contains)
                .toList());
        painter.robots(robots);
        draft.selected().ifPresent(item -> painter.selection(draft.world(), item));
        if (pointer != null) {
            painter.pointer(pointer, measure, tool != EditorTool.SELECT);
        }
    }

    @Override
    protected String spoken() {
        String world = draft.world().name();
        return draft.selected()
                .map(item ->
                        texts.of("editor.spoken.item", world, EditorItems.text(texts, Edits.get(draft.world(), item))))
                .orElse(texts.of("editor.spoken", world));
    }
}
