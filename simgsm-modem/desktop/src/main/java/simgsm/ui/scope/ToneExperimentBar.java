package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.scope.ToneScore;
import simgsm.scope.ToneTrace;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneExperiment;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.Slider;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * Two sliders for noise and frequency shift of a tone scope's sound, the codec applied after them, and the number of
 * keys still detected. The call itself is not changed, and the bar says so.
 * <pre>
 *   What if? Only this scope hears it.        [reset]
 *   Noise --o------- 12 dB    Pitch ----o--- +1.5 %
 *   Codec GSM 06.10
 * </pre>
 */
final class ToneExperimentBar extends JPanel {
    /** The noise slider's steps: none, then an SNR of 30 dB down to -10 dB. */
    private static final int NOISE_STEPS = 41;

    private static final int MOST_SNR_DECIBELS = 30;
    /** The pitch slider's steps are tenths of a percent. */
    private static final int SHIFT_STEPS = 50;

    private static final List<Optional<SpeechCodec.Kind>> CODECS =
            List.of(Optional.empty(), Optional.of(SpeechCodec.Kind.A_LAW), Optional.of(SpeechCodec.Kind.GSM_FULL_RATE));

    private final TextBundle texts;
    private final Consumer<ToneExperiment> chosen;
    private final JLabel verdict = Theme.label("", Theme::small, Ink.QUIET);
    private final Slider noise = new Slider(0, NOISE_STEPS, 0, this::changed);
    private final Slider shift = new Slider(-SHIFT_STEPS, SHIFT_STEPS, 0, this::changed);
    private final JPanel codecRow;
    private final JComboBox<String> codec = new JComboBox<>();
    private final JLabel noiseValue = value();
    private final JLabel shiftValue = value();
    private final JButton reset = new JButton(new UserAction("scope.reset", "", this::reset));
    private final GridLayout columns = new GridLayout(0, 2);
    private final JPanel sliders = new JPanel(columns);
    private ToneExperiment experiment = ToneExperiment.NONE;
    private ToneScore score = ToneScore.NONE;
    private ShownReceiver receiver = ShownReceiver.MODEM;
    private ToneTrace newest = ToneTrace.EMPTY;

    /** @param chosen receives each new experiment, on the event thread */
    ToneExperimentBar(Locale language, Consumer<ToneExperiment> chosen) {
        super(new BorderLayout());
        this.texts = DesktopTexts.in(language);
        this.chosen = chosen;
        setOpaque(false);
        sliders.setOpaque(false);
        sliders.add(row("scope.noise", noise, noiseValue));
        sliders.add(row("scope.shift", shift, shiftValue));
        codecRow = codecRow();
        sliders.add(codecRow);
        reset.setToolTipText(texts.of("scope.reset.tip"));
        ComponentNames.name(reset, "scope.reset", texts.of("scope.reset.tip"));
        Theme.styled(reset, button -> {
            button.setIcon(Symbol.ERASE.icon(14));
            button.setBorder(Theme.padding(0, 4, 0, 4));
            button.setContentAreaFilled(false);
        });
        verdict.setToolTipText(texts.of("scope.experiment.tip"));
        ComponentNames.name(verdict, "scope.verdict", "");
        Theme.styled(verdict, label -> {
            label.setPreferredSize(new Dimension(Theme.px(100), Theme.px(22)));
            label.setMinimumSize(new Dimension(0, Theme.px(22)));
            label.setForeground(verdictColor());
        });
        add(Arrange.row(4, Arrange.growing(verdict), reset), BorderLayout.NORTH);
        add(sliders, BorderLayout.CENTER);
        showState();
    }

    private JPanel row(String key, Slider slider, JLabel value) {
        JLabel label = label(key);
        label.setLabelFor(slider);
        slider.setToolTipText(texts.of(key + ".tip"));
        ComponentNames.name(slider, key, texts.of(key));
        slider.getAccessibleContext().setAccessibleDescription(texts.of(key + ".tip"));
        return Arrange.row(6, label, Arrange.growing(slider), value);
    }

    private JPanel codecRow() {
        for (Optional<SpeechCodec.Kind> kind : CODECS) {
            codec.addItem(kind.map(it -> CodecText.name(texts, it)).orElse(texts.of("scope.codec.none")));
        }
        JLabel label = label("scope.codec");
        label.setLabelFor(codec);
        codec.setToolTipText(texts.of("scope.codec.tip"));
        ComponentNames.name(codec, "scope.codec", texts.of("scope.codec"));
        codec.addActionListener(event -> changed());
        Theme.styled(codec, it -> {
            it.setFont(Theme.small());
            it.setPreferredSize(new Dimension(Theme.px(120), Theme.px(24)));
        });
        return Arrange.row(6, label, codec, Arrange.spring());
    }

    private JLabel label(String key) {
        return Theme.styled(Theme.label(texts.of(key), Theme::small, Ink.QUIET), it -> {
            Dimension size = new Dimension(longestLabel() + Theme.px(4), Theme.px(20));
            it.setPreferredSize(size);
            it.setMinimumSize(size);
        });
    }

    private int longestLabel() {
        return Stream.of("scope.noise", "scope.shift", "scope.codec")
                .mapToInt(key -> Drawing.width(Theme.small(), texts.of(key)))
                .max()
                .orElseThrow();
    }

    private static JLabel value() {
        JLabel value = Theme.label("", Theme::monoSmall, Ink.TEXT);
        value.setHorizontalAlignment(SwingConstants.TRAILING);
        return Theme.styled(
                value,
                it -> it.setPreferredSize(new Dimension(Drawing.width(Theme.monoSmall(), "+10.0 %"), Theme.px(20))));
    }

    /** The codec remains in effect while its row is hidden. */
    void setCodecVisible(boolean visible) {
        if (visible != isCodecVisible()) {
            if (visible) {
                sliders.add(codecRow);
            } else {
                sliders.remove(codecRow);
            }
            revalidate();
        }
    }

    boolean isCodecVisible() {
        return codecRow.getParent() == sliders;
    }

    /** Height of the codec's row. */
    int codecHeight() {
        return codecRow.getPreferredSize().height;
    }

    /** @param narrow true for one slider below the other */
    void arrange(boolean narrow) {
        if (columns.getColumns() != (narrow ? 1 : 2)) {
            columns.setColumns(narrow ? 1 : 2);
            revalidate();
        }
        columns.setHgap(Theme.px(16));
    }

    /** Selects the receiver of the score shown. */
    void show(ShownReceiver newReceiver) {
        receiver = newReceiver;
        show(newest);
    }

    /** Shows the score of the current experiment. */
    void show(ToneTrace trace) {
        newest = trace;
        ToneScore now =
                trace.experiment().equals(experiment) ? receiver.of(trace).score() : ToneScore.NONE;
        if (!now.equals(score)) {
            score = now;
            showState();
        }
    }

    private void changed() {
        double snr = noise.getValue() == 0 ? Double.POSITIVE_INFINITY : MOST_SNR_DECIBELS + 1 - noise.getValue();
        ToneExperiment wanted = new ToneExperiment(snr, shift.getValue() / 10.0, CODECS.get(codec.getSelectedIndex()));
        if (!wanted.equals(experiment)) {
            experiment = wanted;
            score = ToneScore.NONE;
            showState();
            chosen.accept(wanted);
        }
    }

    private void reset() {
        noise.setValue(0);
        shift.setValue(0);
        codec.setSelectedIndex(0);
    }

    private void showState() {
        boolean none = experiment.equals(ToneExperiment.NONE);
        noiseValue.setText(
                experiment.hasNoise()
                        ? texts.of("scope.decibels", String.valueOf((int) experiment.snrDecibels()))
                        : texts.of("scope.noise.none"));
        shiftValue.setText(String.format(Locale.ROOT, "%+.1f %%", experiment.shiftPercent())
                .replace("-0.0", "+0.0"));
        verdict.setText(none ? texts.of("scope.experiment") : verdictText());
        verdict.setForeground(verdictColor());
        verdict.getAccessibleContext().setAccessibleName(verdict.getText());
        reset.setVisible(!none);
    }

    private Color verdictColor() {
        return Theme.color(experiment.equals(ToneExperiment.NONE) ? Ink.QUIET : Ink.WARNING);
    }

    private String verdictText() {
        if (score.equals(ToneScore.NONE)) {
            return texts.of("scope.trying");
        }
        String heard = texts.of("scope.heard", String.valueOf(score.heard()), String.valueOf(score.keys()));
        return score.invented() == 0 ? heard : texts.of("scope.invented", heard, String.valueOf(score.invented()));
    }
}
