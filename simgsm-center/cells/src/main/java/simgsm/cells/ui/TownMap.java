package simgsm.cells.ui;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javax.accessibility.AccessibleRole;
import javax.swing.KeyStroke;
import simgsm.cells.radio.Propagation;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Tower;
import simgsm.cells.town.TownPlace;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.PaintedComponent;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * The map. The mouse drags mobiles and clicks towers on and off; with Shift it draws a path for the selected mobile. The
 * arrow keys move the selected mobile by a fiftieth of the map, with Shift by a five hundredth.
 */
final class TownMap extends PaintedComponent {
    private static final double STEP = 1 / 50.0;
    private static final double FINE_STEP = 1 / 500.0;
    /** Maximum distance of a mouse hit, in units. */
    private static final double REACH_UNITS = 14;
    /** Minimum distance of a drawn path's points, in units. */
    private static final double PATH_UNITS = 8;

    private final TextBundle texts;
    private final transient TownActions town;
    private final transient CoverageView coverage;
    private final transient Consumer<String> selected;
    private final transient List<TownPlace> drawn = new ArrayList<>();
    private transient TownSnapshot snapshot;
    private transient Optional<String> selection = Optional.empty();
    private transient Optional<String> dragged = Optional.empty();
    private double walkMetresPerSecond = 1.5;
    private boolean showsLevels = true;
    private boolean showsBorders = true;
    private boolean showsPaths = true;

    /**
     * @param first the initial snapshot
     * @param selected receives the number of a mobile selected with the mouse
     */
    TownMap(
            TextBundle texts,
            TownActions town,
            TownSnapshot first,
            Propagation propagation,
            Executor worker,
            Executor eventThread,
            Consumer<String> selected) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        this.town = town;
        this.selected = selected;
        snapshot = first;
        coverage = new CoverageView(propagation, worker, eventThread, this::repaint);
        setName("map");
        setToolTipText(texts.of("map.why"));
        makeFocusable();
        arrow(KeyEvent.VK_LEFT, "west", -1, 0);
        arrow(KeyEvent.VK_RIGHT, "east", 1, 0);
        arrow(KeyEvent.VK_UP, "north", 0, 1);
        arrow(KeyEvent.VK_DOWN, "south", 0, -1);
        Mouse mouse = new Mouse();
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    private void arrow(int key, String name, int east, int north) {
        new UserAction("map." + name, name, () -> step(east * STEP, north * STEP))
                .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, 0));
        new UserAction("map.fine." + name, name, () -> step(east * FINE_STEP, north * FINE_STEP))
                .bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke(key, InputEvent.SHIFT_DOWN_MASK));
    }

    private void step(double east, double north) {
        double side = Math.max(snapshot.town().widthMetres(), snapshot.town().heightMetres());
        selectedMobile().ifPresent(mobile -> {
            TownPlace place = mobile.place();
            town.place(
                    mobile.number(),
                    snapshot.town().within(place.xMetres() + east * side, place.yMetres() + north * side));
        });
    }

    void show(TownSnapshot newest) {
        change(() -> snapshot = newest);
        repaint();
    }

    void select(Optional<String> number) {
        change(() -> selection = number);
        repaint();
    }

    void showLevels(boolean shown) {
        showsLevels = shown;
        repaint();
    }

    void showBorders(boolean shown) {
        showsBorders = shown;
        repaint();
    }

    void showPaths(boolean shown) {
        showsPaths = shown;
        repaint();
    }

    /** Sets the speed of newly drawn paths. */
    void walkAt(double metresPerSecond) {
        walkMetresPerSecond = metresPerSecond;
    }

    private Optional<MobileState> selectedMobile() {
        return selection.flatMap(number -> snapshot.mobiles().stream()
                .filter(mobile -> mobile.number().equals(number))
                .findFirst());
    }

    private MapScale scale() {
        return MapScale.fitting(snapshot.town(), getWidth(), getHeight());
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Theme.px(720), Theme.px(520));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Theme.px(240), Theme.px(160));
    }

    @Override
    protected String spoken() {
        String what = texts.of(
                "map.spoken",
                snapshot.town().name(),
                snapshot.cells().size(),
                snapshot.mobiles().size());
        return selectedMobile()
                .map(mobile -> what + " "
                        + texts.of(
                                "map.spoken.mobile",
                                mobile.number(),
                                Math.round(mobile.place().xMetres()),
                                Math.round(mobile.place().yMetres()),
                                mobile.cell()))
                .orElse(what);
    }

    @Override
    protected void paint(Graphics2D g, double width, double height) {
        MapScale scale = scale();
        GraphicsCanvas canvas = new GraphicsCanvas(g);
        canvas.ink(Ink.FLOOR);
        canvas.bar(scale.left(), scale.top(), scale.width(), scale.height());
        double margin = selectedMobile().map(MobileState::marginDecibels).orElse(3.0);
        coverage.image(
                        snapshot,
                        scale.pixelsPerMetre() * g.getTransform().getScaleX(),
                        Theme.appearance(),
                        showsLevels,
                        showsBorders,
                        margin)
                .ifPresent(image -> draw(g, image, scale));
        new TownPicture(snapshot, scale, texts, canvas).draw(selection, showsPaths, drawn);
        if (showsLevels) {
            new LevelLegend(texts).draw(canvas, scale);
        }
    }

    private static void draw(Graphics2D g, BufferedImage image, MapScale scale) {
        Graphics2D copy = (Graphics2D) g.create();
        copy.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        copy.drawImage(
                image,
                (int) Math.round(scale.left()),
                (int) Math.round(scale.top()),
                (int) Math.round(scale.width()),
                (int) Math.round(scale.height()),
                null);
        copy.dispose();
    }

    private Optional<MobileState> mobileAt(double x, double y) {
        MapScale scale = scale();
        double nearest = Theme.exact(REACH_UNITS);
        Optional<MobileState> hit = Optional.empty();
        for (MobileState mobile : snapshot.mobiles()) {
            double distance = Math.hypot(
                    scale.x(mobile.place().xMetres()) - x,
                    scale.y(mobile.place().yMetres()) - y);
            if (distance < nearest) {
                nearest = distance;
                hit = Optional.of(mobile);
            }
        }
        return hit;
    }

    private Optional<CellState> towerAt(double x, double y) {
        MapScale scale = scale();
        for (int i = 0; i < snapshot.cells().size(); i++) {
            Tower tower = snapshot.town().towers().get(i);
            double dx = scale.x(tower.place().xMetres()) - x;
            double dy = y - scale.y(tower.place().yMetres());
            boolean isHit = Math.abs(dx) < Theme.exact(REACH_UNITS)
                    && dy > -Theme.exact(TownPicture.MAST_UNITS + 6)
                    && dy < Theme.exact(REACH_UNITS + 4);
            if (isHit) {
                return Optional.of(snapshot.cells().get(i));
            }
        }
        return Optional.empty();
    }

    private final class Mouse extends MouseAdapter {
        @Override
        public void mousePressed(MouseEvent event) {
            requestFocusInWindow();
            if (event.isShiftDown() && selection.isPresent()) {
                drawn.clear();
                selectedMobile().ifPresent(mobile -> drawn.add(mobile.place()));
                return;
            }
            dragged = mobileAt(event.getX(), event.getY()).map(MobileState::number);
            if (dragged.isPresent()) {
                selected.accept(dragged.get());
            } else {
                towerAt(event.getX(), event.getY()).ifPresent(cell -> town.switchTower(cell.name(), !cell.isOn()));
            }
        }

        @Override
        public void mouseDragged(MouseEvent event) {
            MapScale scale = scale();
            TownPlace place = scale.place(event.getX(), event.getY());
            if (!drawn.isEmpty()) {
                double apart = Theme.exact(PATH_UNITS) / scale.pixelsPerMetre();
                if (drawn.get(drawn.size() - 1).distanceMetres(place) >= apart) {
                    drawn.add(place);
                    repaint();
                }
            } else {
                dragged.ifPresent(number -> town.place(number, place));
            }
        }

        @Override
        public void mouseReleased(MouseEvent event) {
            if (drawn.size() > 1) {
                selection.ifPresent(number -> town.walk(number, List.copyOf(drawn), walkMetresPerSecond));
            }
            drawn.clear();
            dragged = Optional.empty();
            repaint();
        }

        @Override
        public void mouseMoved(MouseEvent event) {
            boolean isOver = mobileAt(event.getX(), event.getY()).isPresent()
                    || towerAt(event.getX(), event.getY()).isPresent();
            setCursor(Cursor.getPredefinedCursor(isOver ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
        }
    }
}
