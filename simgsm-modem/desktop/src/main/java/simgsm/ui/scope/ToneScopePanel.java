package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.dtmf.DtmfKey;
import simgsm.scope.KeyPrediction;
import simgsm.scope.PracticeTone;
import simgsm.scope.ScopeInstrument;
import simgsm.scope.ScopeInstrument.Picture;
import simgsm.scope.ToneTrace;
import simgsm.tone.ToneExperiment;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;
import simgsm.ui.glossary.TermPanel;

/**
 * The tone scope of phone and modem: tools above the picture; below it the question of a prediction, the receivers
 * with their candidate keys, and the experiment. A small one opens a large one in its own window.
 */
public final class ToneScopePanel extends JPanel {
    /** Units; the sliders of a narrower scope are one below the other. */
    private static final int NARROW = 440;
    /** Units; a lower compact scope hides the row of the receiver. */
    private static final int LOW = 174;
    /** Units; a higher scope has room for the receivers below a question. */
    private static final int HIGH = 440;

    private static final String NAME = "scope";
    private static final String FREEZE = "scope.freeze";
    private static final String PREDICT = "scope.predict";
    private static final String SPECTROGRAM = "scope.spectrogram";
    /** Offered once a word has been compared. */
    private static final String WORD = "scope.word";

    private final Locale language;
    private final TextBundle texts;
    private final Consumer<ToneExperiment> chosen;
    private final ScopeInstrument instrument = new ScopeInstrument();
    private final PracticeTone practice = new PracticeTone(System.nanoTime());
    private final ToneScope scope;
    private final ScopeTools tools;
    private final PredictionBar prediction;
    private final ReceiverPanel receivers;
    private final ToneExperimentBar experiment;
    private final JPanel below;
    /** Shows the terms, made when first asked for: the layout of their text takes long. */
    private final JPanel terms = new JPanel(new BorderLayout());

    private TermPanel termPanel;
    private final UserAction leave;
    /** Component focused before the question. */
    private Component keyboardBefore;

    private Consumer<Boolean> whenHiding = hiding -> {};
    /** Called with true when a question of this scope, not of its enlarged one, hides keys; with false at its end. */
    private Consumer<Boolean> whenAsking = asking -> {};

    private boolean wasHiding;
    private boolean wasAsking;
    private boolean isCompact;
    private ToneTrace newest = ToneTrace.EMPTY;
    private LargeScope large;

    /**
     * An empty scope.
     *
     * @param chosen receives each new experiment, on the event thread; the scope's owner passes it to its tracer
     */
    public ToneScopePanel(Locale language, Consumer<ToneExperiment> chosen) {
        this(language, chosen, true);
    }

    /** @param opensLarge true for a button that opens a large scope */
    ToneScopePanel(Locale language, Consumer<ToneExperiment> chosen, boolean opensLarge) {
        super(new BorderLayout());
        this.language = language;
        this.chosen = chosen;
        texts = DesktopTexts.in(language);
        setOpaque(false);
        setName(NAME);
        scope = new ToneScope(language, instrument, this::guess);
        experiment = new ToneExperimentBar(language, chosen);
        receivers = new ReceiverPanel(language, !opensLarge, this::select);
        prediction = new PredictionBar(texts, instrument.prediction(), this::guess, this::practise);
        prediction.setVisible(false);
        tools = new ScopeTools(texts);
        addTools(opensLarge);
        if (opensLarge) {
            UserAction enlarge = new UserAction("scope.large.key", texts.of("scope.large"), this::openLarge);
            enlarge.bind(scope, WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0));
        }
        UserAction freeze = new UserAction("scope.freeze.key", texts.of("scope.freeze"), () -> tools.press(FREEZE));
        freeze.bind(scope, WHEN_FOCUSED, KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0));
        leave = new UserAction("scope.predict.leave", texts.of("scope.predict.leave"), () -> tools.press(PREDICT));
        leave.setEnabled(false);
        leave.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0));
        add(tools, BorderLayout.NORTH);
        add(scope, BorderLayout.CENTER);
        terms.setOpaque(false);
        terms.setVisible(false);
        below = Arrange.column(Theme.HALF, terms, prediction, receivers, experiment);
        add(below, BorderLayout.SOUTH);
    }

    private void addTools(boolean opensLarge) {
        tools.toggle(FREEZE, Symbol.PAUSE, on -> scope.changed(() -> instrument.freeze(on)));
        tools.toggle("scope.cursors", Symbol.CURSORS, on -> scope.changed(() -> instrument.setCursors(on)));
        tools.toggle(SPECTROGRAM, Symbol.SPECTROGRAM, on -> choose(on, Picture.SPECTROGRAM, WORD));
        tools.toggle(WORD, Symbol.WORD, on -> choose(on, Picture.WORD, SPECTROGRAM));
        tools.setVisible(WORD, false);
        tools.toggle("scope.compare", Symbol.COMPARE, on -> scope.changed(() -> instrument.compare(on)));
        tools.toggle(PREDICT, Symbol.QUESTION, this::predict);
        tools.toggle("scope.terms", Symbol.BOOK, this::explain);
        if (opensLarge) {
            tools.button("scope.large", Symbol.FIT, this::openLarge);
        }
    }

    /** @param other button of the picture that this one replaces */
    private void choose(boolean on, Picture picture, String other) {
        if (on && tools.isOn(other)) {
            tools.press(other);
        }
        scope.changed(() -> instrument.choose(on ? picture : Picture.LEVELS));
    }

    private void select(ShownReceiver receiver) {
        scope.show(receiver);
        experiment.show(receiver);
    }

    private void predict(boolean on) {
        Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
        boolean hadKeyboard = prediction.hasFocus(owner);
        if (on) {
            thaw();
        }
        instrument.prediction().set(on);
        prediction.setVisible(on);
        leave.setEnabled(on);
        updatePrediction();
        if (on) {
            keyboardBefore = owner;
            prediction.focusField();
        } else if (hadKeyboard) {
            giveKeyboardBack();
        }
    }

    /** A question is about the current sound, not a frozen picture. */
    private void thaw() {
        if (tools.isOn(FREEZE)) {
            tools.press(FREEZE);
        }
    }

    private void giveKeyboardBack() {
        if (keyboardBefore != null && keyboardBefore.isShowing()) {
            keyboardBefore.requestFocusInWindow();
        } else {
            scope.requestFocusInWindow();
        }
    }

    /** Replaces receivers and experiment by the terms. */
    private void explain(boolean on) {
        terms.setVisible(on);
        experiment.setVisible(!on && !isCompact);
        if (on && termPanel == null) {
            termPanel =
                    new TermPanel(language, List.of(texts.of("scope.terms.list").split(", ")));
            terms.add(termPanel);
        }
        revalidate();
        if (on) {
            termPanel.focusFirst();
        }
    }

    private void guess(DtmfKey key) {
        instrument.prediction().guess(key);
        updatePrediction();
    }

    private void practise() {
        thaw();
        PracticeTone.Played played = practice.next(newest.experiment());
        instrument.prediction().ask(played.trace(), played.key());
        updatePrediction();
        prediction.focusField();
    }

    private void updatePrediction() {
        prediction.update();
        updateHiding();
        boolean isAsking = instrument.prediction().isHiding();
        if (isAsking != wasAsking) {
            wasAsking = isAsking;
            whenAsking.accept(isAsking);
            if (large != null) {
                large.panel().conceal(isAsking);
            }
        }
    }

    Locale language() {
        return language;
    }

    /** Hides keys during a question of the other scope of the same sound. */
    void conceal(boolean concealed) {
        instrument.conceal(concealed);
        updateHiding();
    }

    private void updateHiding() {
        scope.changed(() -> {});
        boolean isHiding = instrument.isHiding();
        receivers.setHiding(isHiding);
        receivers.show(instrument.trace());
        if (isHiding != wasHiding) {
            wasHiding = isHiding;
            whenHiding.accept(isHiding);
            revalidate();
        }
    }

    /** @param listener called with true when keys must be hidden in the whole window, with false at the end */
    public void whenHiding(Consumer<Boolean> listener) {
        whenHiding = listener;
    }

    /** A scope of the same sound for its own window; during a question of one, both hide the key. */
    ToneScopePanel enlarged() {
        ToneScopePanel panel = new ToneScopePanel(language, chosen, false);
        panel.whenAsking = this::conceal;
        panel.conceal(instrument.prediction().isHiding());
        return panel;
    }

    /** Opens a large scope of the same sound, or brings it to the front. */
    private void openLarge() {
        if (large == null || !large.isOpen()) {
            openLarge(Optional.empty());
        } else {
            large.toFront();
        }
    }

    private void openLarge(Optional<Rectangle> place) {
        large = LargeScope.open(this, place);
        large.show(newest);
    }

    /** A window that changes its language makes another scope, which then owns the large one. */
    @Override
    public void removeNotify() {
        super.removeNotify();
        if (large != null && large.isOpen()) {
            SwingUtilities.invokeLater(this::passLargeOn);
        }
    }

    private void passLargeOn() {
        if (isDisplayable() || !large.isOpen()) {
            return;
        }
        Rectangle place = large.dialog().getBounds();
        large.dialog().dispose();
        ComponentNames.find(large.dialog().getOwner(), NAME)
                .ifPresent(next -> ((ToneScopePanel) next).openLarge(Optional.of(place)));
    }

    /** A compact scope is lower, has one receiver's row and no sliders; their settings remain in effect. */
    public void setCompact(boolean compact) {
        scope.setCompact(compact);
        receivers.setCompact(compact);
        experiment.setVisible(!compact && !terms.isVisible());
        isCompact = compact;
    }

    @Override
    public void doLayout() {
        experiment.arrange(getWidth() < Theme.px(NARROW));
        boolean asks = prediction.isVisible();
        boolean hasRoom = asks ? getHeight() >= Theme.px(HIGH) : !isCompact || getHeight() >= Theme.px(LOW);
        receivers.setVisible(hasRoom && !terms.isVisible());
        int spare = getHeight() - leastHeight();
        int toolsHeight = tools.getPreferredSize().height;
        tools.setVisible(spare >= toolsHeight);
        experiment.setCodecVisible(spare >= toolsHeight + experiment.codecHeight());
        super.doLayout();
    }

    /** The lowest picture and the components below it, without tools and codec. */
    private int leastHeight() {
        int least = Theme.px(ToneScope.COMPACT_HEIGHT) + below.getPreferredSize().height;
        return least - (experiment.isVisible() && experiment.isCodecVisible() ? experiment.codecHeight() : 0);
    }

    /** Tools and codec are shown if there is room. */
    @Override
    public Dimension getPreferredSize() {
        if (isPreferredSizeSet()) {
            return super.getPreferredSize();
        }
        int picture = scope.getPreferredSize().height - Theme.px(ToneScope.COMPACT_HEIGHT);
        return new Dimension(scope.getPreferredSize().width, leastHeight() + picture);
    }

    public void show(ToneTrace trace) {
        newest = trace;
        if (trace.word().isPresent()) {
            tools.setVisible(WORD, true);
        }
        KeyPrediction.Stage before = instrument.prediction().stage();
        scope.show(trace);
        if (before != instrument.prediction().stage()) {
            updatePrediction();
        }
        receivers.show(instrument.trace());
        experiment.show(trace);
        if (large != null) {
            large.show(trace);
        }
    }
}
