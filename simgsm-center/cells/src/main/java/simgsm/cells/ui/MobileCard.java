package simgsm.cells.ui;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.cells.town.Town;
import simgsm.cells.town.Walk;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/** The selected mobile: its cell and levels, the values of the controller's decision, and its walk. */
final class MobileCard extends JPanel {
    private static final double SPEED_LEAST = 0.5;
    private static final double SPEED_MOST = 100;

    private final TextBundle texts;
    private final transient TownActions town;
    private final transient Consumer<String> chosen;
    private final JComboBox<String> numbers = new JComboBox<>();
    private final Lamp state;
    private final JLabel radio = Theme.label(" ", Theme::monoSmall, Ink.QUIET);
    private final LevelBars levels;
    private final LevelHistory history;
    private final DecisionCount decision;
    private final JLabel gap = Theme.label(" ", Theme::monoStrong, Ink.TEXT);
    private final JComboBox<String> walks = new JComboBox<>();
    private final JSpinner speed = new JSpinner(new SpinnerNumberModel(1.5, SPEED_LEAST, SPEED_MOST, 0.5));
    private final JButton walk;
    private final JButton stand;
    private transient Optional<MobileState> shown = Optional.empty();
    private transient List<Walk> offered = List.of();
    private boolean isShowing;

    /**
     * @param chosen receives the number selected in the list
     * @param speedChosen receives the selected speed of walks in m/s
     */
    MobileCard(TextBundle texts, TownActions town, Consumer<String> chosen, DoubleConsumer speedChosen) {
        super(new BorderLayout());
        this.texts = texts;
        this.town = town;
        this.chosen = chosen;
        setOpaque(false);
        state = new Lamp(texts.of("mobile.state.name"));
        state.setName("mobile.state");
        radio.setName("mobile.radio");
        gap.setName("mobile.gap");
        levels = new LevelBars(texts);
        history = new LevelHistory(texts);
        decision = new DecisionCount(texts);
        ComponentNames.name(numbers, "mobiles", texts.of("mobile.choice"));
        ComponentNames.name(walks, "walks", texts.of("walk.choice"));
        ComponentNames.name(speed, "speed", texts.of("walk.speed"));
        nameEditor();
        numbers.addActionListener(event -> choose());
        walks.addActionListener(event -> adoptSpeed());
        // the whole name, which the list may truncate
        walks.addActionListener(event -> walks.setToolTipText((String) walks.getSelectedItem()));
        speed.addChangeListener(event -> speedChosen.accept(metresPerSecond()));
        speed.setToolTipText(texts.of("walk.speed"));
        walk = new JButton(UserAction.of(texts, "walk", "walk.start", this::startWalk));
        stand = new JButton(UserAction.of(texts, "stand", "walk.stop", this::stopWalk));
        ComponentNames.name(walk, "walk", texts.of("walk.start"));
        ComponentNames.name(stand, "stand", texts.of("walk.stop"));
        layOut();
        show(Optional.empty());
    }

    private void layOut() {
        add(
                Arrange.column(
                        6,
                        Arrange.row(Theme.GRID, numbers, Arrange.growing(state)),
                        // Above the figures, so that it is in view where there is little room.
                        Arrange.row(
                                Theme.HALF,
                                Arrange.growing(walks),
                                speed,
                                Theme.label("m/s", Theme::small, Ink.QUIET),
                                walk,
                                stand),
                        radio,
                        Arrange.growing(levels),
                        history,
                        decision,
                        gap),
                BorderLayout.CENTER);
    }

    /** Names the text field in the spinner, which has its keys. */
    private void nameEditor() {
        if (speed.getEditor() instanceof JSpinner.DefaultEditor editor) {
            ComponentNames.name(editor.getTextField(), "speed.field", texts.of("walk.speed"));
            editor.getTextField().setColumns(3);
        }
    }

    private double metresPerSecond() {
        return ((Number) speed.getValue()).doubleValue();
    }

    private void choose() {
        if (!isShowing && numbers.getSelectedItem() instanceof String number) {
            chosen.accept(number);
        }
    }

    private void adoptSpeed() {
        int index = walks.getSelectedIndex();
        if (!isShowing && index >= 0) {
            speed.setValue(Math.max(
                    SPEED_LEAST, Math.min(SPEED_MOST, offered.get(index).metresPerSecond())));
        }
    }

    private void startWalk() {
        int index = walks.getSelectedIndex();
        if (index >= 0) {
            shown.ifPresent(
                    mobile -> town.walk(mobile.number(), offered.get(index).points(), metresPerSecond()));
        }
    }

    private void stopWalk() {
        shown.map(MobileState::number).ifPresent(town::stand);
    }

    /** Shows the newest snapshot. @param selected the mobile's number */
    void show(TownSnapshot snapshot, Optional<String> selected) {
        isShowing = true;
        List<String> present =
                snapshot.mobiles().stream().map(MobileState::number).toList();
        if (!items(numbers).equals(present)) {
            numbers.removeAllItems();
            present.forEach(numbers::addItem);
        }
        selected.filter(number -> !number.equals(numbers.getSelectedItem())).ifPresent(numbers::setSelectedItem);
        offer(snapshot.town());
        isShowing = false;
        Optional<MobileState> mobile = selected.flatMap(number -> snapshot.mobiles().stream()
                .filter(candidate -> candidate.number().equals(number))
                .findFirst());
        show(mobile);
        levels.show(snapshot.town().towers(), mobile);
        history.show(snapshot, mobile);
    }

    private static List<String> items(JComboBox<String> box) {
        return IntStream.range(0, box.getItemCount()).mapToObj(box::getItemAt).toList();
    }

    private void offer(Town current) {
        if (!offered.equals(current.walks())) {
            offered = current.walks();
            walks.removeAllItems();
            offered.forEach(each -> walks.addItem(each.name()));
            if (!offered.isEmpty()) {
                speed.setValue(offered.get(0).metresPerSecond());
            }
        }
    }

    private void show(Optional<MobileState> mobile) {
        shown = mobile;
        walk.setEnabled(mobile.isPresent() && !offered.isEmpty());
        stand.setEnabled(mobile.isPresent() && !mobile.get().path().isEmpty());
        if (mobile.isEmpty()) {
            state.show(StatusMark.RING, Ink.QUIET, texts.of("mobile.none"));
            radio.setText(" ");
            gap.setText(" ");
            decision.show(OptionalInt.empty(), 1, 0);
            return;
        }
        MobileState it = mobile.get();
        String word = texts.of("mobile.state." + it.state().name().toLowerCase(Locale.ROOT));
        String said = it.isInCall() ? texts.of("mobile.call", word) : word;
        state.show(
                it.isCiphered() ? StatusMark.LOCK : TownPicture.markOf(it.state()),
                it.state() == MobileState.State.SEARCHING ? Ink.DANGER : Ink.TEXT,
                it.isCiphered() ? texts.of("mobile.ciphered", said) : said);
        radio.setText(
                it.quality().isPresent() || it.timingAdvance().isPresent()
                        ? texts.of(
                                "mobile.radio",
                                figure(it.quality()),
                                figure(it.timingAdvance()),
                                figure(it.linkCounter()))
                        : texts.of("mobile.radio.idle", it.cell().isEmpty() ? "-" : it.cell()));
        decision.show(it.reportsToDecision(), it.periodReports(), it.marginDecibels());
        gap.setText(
                it.gapMillis().isPresent()
                        ? texts.of("mobile.gap", String.valueOf(it.gapMillis().getAsInt()))
                        : " ");
    }

    private static String figure(OptionalInt value) {
        return value.isPresent() ? String.valueOf(value.getAsInt()) : "-";
    }
}
