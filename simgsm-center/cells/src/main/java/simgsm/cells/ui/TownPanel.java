package simgsm.cells.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Executor;
import javax.swing.JComponent;
import javax.swing.JPanel;
import simgsm.cells.radio.Propagation;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Tower;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.Card;
import simgsm.ui.DressedPanel;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.pane.DividedPanel;
import simgsm.ui.pane.Divider;
import simgsm.ui.pane.ScrolledColumn;

/** The content of the town's window: shows snapshots and performs the user's actions. Needs no display. */
public final class TownPanel extends DressedPanel {
    /** Initial size of the window, if the screen permits it. */
    static final Dimension SIZE_UNITS = new Dimension(1100, 760);

    private static final int MARGIN_UNITS = 12;
    private static final int SIDE_UNITS = 350;
    private static final int LEAST_SIDE_UNITS = 300;
    private static final int LEAST_MAP_UNITS = 260;

    private final TownHeader header;
    private final TownMap map;
    private final MobileCard mobile;
    private final PassingStrip strip;
    private final List<TowerRow> rows = new ArrayList<>();
    private Optional<String> selected = Optional.empty();
    /**
     * True once the user has selected a mobile; before, the one with the lowest number is shown, whatever the order of
     * arrival.
     */
    private boolean isChosen;

    private TownSnapshot snapshot;
    private double shownZoom;

    /**
     * Creates the panel.
     *
     * @param first the initial snapshot; later ones have the same town
     * @param propagation of that town, with the core's seed
     * @param worker computes the coverage
     * @param eventThread runs the updates
     */
    public TownPanel(
            TextBundle texts,
            TownActions town,
            TownSnapshot first,
            Propagation propagation,
            Executor worker,
            Executor eventThread) {
        snapshot = first;
        map = new TownMap(texts, town, first, propagation, worker, eventThread, this::select);
        header = new TownHeader(texts, town, map, first);
        mobile = new MobileCard(texts, town, this::select, map::walkAt);
        strip = new PassingStrip(texts);
        JPanel mapSheet = new JPanel(new BorderLayout());
        mapSheet.setOpaque(false);
        mapSheet.add(map, BorderLayout.CENTER);
        Divider divider = new Divider(
                "divider.mobile",
                texts.of("divider.mobile"),
                Locale.forLanguageTag(texts.of("language.tag")),
                LEAST_SIDE_UNITS);
        JPanel split = new DividedPanel(
                true, new Card(mapSheet), side(texts, town, first), divider, LEAST_MAP_UNITS, TownPanel::sideWidth);
        add(Arrange.column(MARGIN_UNITS, header, Arrange.growing(split), new Card(strip)), BorderLayout.CENTER);
        dress();
        show(first);
    }

    private JComponent side(TextBundle texts, TownActions town, TownSnapshot first) {
        List<Tower> towers = first.town().towers();
        for (int i = 0; i < towers.size(); i++) {
            rows.add(new TowerRow(texts, town, towers.get(i), i));
        }
        Card towerCard =
                new Card(texts.of("towers.title"), Arrange.column(Theme.HALF, rows.toArray(JComponent[]::new)));
        JComponent column =
                Arrange.column(MARGIN_UNITS, new Card(texts.of("mobile.title"), mobile), towerCard, Arrange.spring());
        return new VerticalScrollPane(new ScrolledColumn(column)).bare();
    }

    private static int sideWidth(int room) {
        return Math.max(Theme.px(LEAST_SIDE_UNITS), Math.min(Theme.px(SIDE_UNITS), room - Theme.px(LEAST_MAP_UNITS)));
    }

    private void select(String number) {
        isChosen = true;
        selected = Optional.of(number);
        map.select(selected);
        mobile.show(snapshot, selected);
        strip.show(snapshot.passing(), selected);
    }

    /** Shows the newest snapshot; called on the event thread. */
    public void show(TownSnapshot newest) {
        snapshot = newest;
        boolean isThere = isChosen
                && newest.mobiles().stream()
                        .anyMatch(candidate -> candidate.number().equals(selected.get()));
        if (!isThere) {
            isChosen = false;
            selected = newest.mobiles().stream().findFirst().map(MobileState::number);
            map.select(selected);
        }
        header.show(newest);
        map.show(newest);
        mobile.show(newest, selected);
        for (int i = 0; i < rows.size(); i++) {
            rows.get(i).show(newest.cells().get(i));
        }
        strip.show(newest.passing(), selected);
    }

    /** Focuses the map. */
    @Override
    public boolean requestFocusInWindow() {
        return map.requestFocusInWindow();
    }

    @Override
    protected void dress() {
        setBackground(Theme.color(Ink.SURFACE));
        setBorder(Theme.padding(MARGIN_UNITS));
        if (shownZoom != Theme.zoom()) {
            shownZoom = Theme.zoom();
            setPreferredSize(new Dimension(Theme.px(SIZE_UNITS.width), Theme.px(SIZE_UNITS.height)));
        }
    }
}
