package simgsm.ui.scope;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneScore;
import simgsm.dtmf.ToneTrace;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.UserAction;

/**
 * What if there were noise, or the tones were off pitch? Two sliders for what a tone scope does to the sound that it hears,
 * and how many keys it still hears then. The call itself stays as it is, and the bar says so.
 *
 * <pre>
 *   What if? Only this scope hears it.        [reset]
 *   Noise --o------- 12 dB    Pitch ----o--- +1.5 %
 * </pre>
 */
final class ToneExperimentBar extends JPanel {
    /** The noise slider's steps: none, then an SNR of 30 dB down to -10 dB. */
    private static final int NOISE_STEPS = 41;

    private static final int MOST_SNR_DECIBELS = 30;
    /** The pitch slider's steps are tenths of a percent. */
    private static final int SHIFT_STEPS = 50;

    private final TextBundle texts;
    private final Consumer<ToneExperiment> chosen;
    private final JLabel verdict = new JLabel();
    private final Slider noise = new Slider(0, NOISE_STEPS, 0, this::changed);
    private final Slider shift = new Slider(-SHIFT_STEPS, SHIFT_STEPS, 0, this::changed);
    private final JLabel noiseLabel;
    private final JLabel shiftLabel;
    private final JLabel noiseValue = new JLabel();
    private final JLabel shiftValue = new JLabel();
    private final JButton reset;
    private final JPanel loudness;
    private final JPanel pitch;
    private JPanel faders;
    private boolean isNarrow;
    private ToneExperiment experiment = ToneExperiment.NONE;
    private ToneScore score = ToneScore.NONE;

    /** @param chosen told each experiment that is set, on the event thread */
    ToneExperimentBar(Locale language, Consumer<ToneExperiment> chosen) {
        super(new BorderLayout());
        this.texts = DesktopTexts.in(language);
        this.chosen = chosen;
        setOpaque(false);
        noiseLabel = label("scope.noise", noise);
        shiftLabel = label("scope.shift", shift);
        reset = new JButton(new UserAction("scope.reset", "", this::reset));
        reset.setToolTipText(texts.of("scope.reset.tip"));
        ComponentNames.name(reset, "scope.reset", texts.of("scope.reset.tip"));
        ComponentNames.name(verdict, "scope.verdict", "");
        loudness = Arrange.growing(Arrange.row(6, noiseLabel, Arrange.growing(noise), noiseValue));
        pitch = Arrange.growing(Arrange.row(6, shiftLabel, Arrange.growing(shift), shiftValue));
        add(Arrange.row(4, Arrange.growing(verdict), reset), BorderLayout.NORTH);
        arrange(false);
        dress();
        tell();
    }

    /** @param narrow whether the faders lie one below the other */
    void arrange(boolean narrow) {
        if (faders == null || narrow != isNarrow) {
            isNarrow = narrow;
            if (faders != null) {
                remove(faders);
            }
            faders = narrow ? Arrange.column(0, loudness, pitch) : Arrange.row(16, loudness, pitch);
            add(faders, BorderLayout.CENTER);
            revalidate();
        }
    }

    private JLabel label(String key, Slider slider) {
        JLabel label = new JLabel(texts.of(key));
        label.setLabelFor(slider);
        slider.setToolTipText(texts.of(key + ".tip"));
        ComponentNames.name(slider, key, texts.of(key + ".tip"));
        return label;
    }

    /** How the experiment goes. */
    void show(ToneTrace trace) {
        ToneScore now = trace.experiment().equals(experiment) ? trace.score() : ToneScore.NONE;
        if (!now.equals(score)) {
            score = now;
            tell();
        }
    }

    private void changed() {
        double snr = noise.value() == 0 ? Double.POSITIVE_INFINITY : MOST_SNR_DECIBELS + 1 - noise.value();
        ToneExperiment wanted = new ToneExperiment(snr, shift.value() / 10.0);
        if (!wanted.equals(experiment)) {
            experiment = wanted;
            score = ToneScore.NONE;
            tell();
            chosen.accept(wanted);
        }
    }

    private void reset() {
        noise.setValue(0);
        shift.setValue(0);
    }

    private void tell() {
        boolean none = experiment.equals(ToneExperiment.NONE);
        noiseValue.setText(
                experiment.hasNoise()
                        ? texts.of("scope.decibels", String.valueOf((int) experiment.snrDecibels()))
                        : texts.of("scope.noise.none"));
        shiftValue.setText(String.format(Locale.ROOT, "%+.1f %%", experiment.shiftPercent())
                .replace("-0.0", "+0.0"));
        verdict.setText(none ? texts.of("scope.experiment") : verdictText());
        verdict.setForeground(none ? Theme.color(Ink.QUIET) : Theme.color(Ink.WARNING));
        verdict.getAccessibleContext().setAccessibleName(verdict.getText());
        verdict.setToolTipText(texts.of("scope.experiment.tip"));
        reset.setVisible(!none);
    }

    private String verdictText() {
        if (score.equals(ToneScore.NONE)) {
            return texts.of("scope.trying");
        }
        String heard = texts.of("scope.heard", String.valueOf(score.heard()), String.valueOf(score.keys()));
        return score.invented() == 0 ? heard : texts.of("scope.invented", heard, String.valueOf(score.invented()));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (reset != null) {
            dress();
            tell();
        }
    }

    private void dress() {
        for (JLabel label : new JLabel[] {verdict, noiseLabel, shiftLabel}) {
            label.setFont(Theme.small());
            label.setForeground(Theme.color(Ink.QUIET));
        }
        int longer = Math.max(
                Drawing.width(Theme.small(), noiseLabel.getText()), Drawing.width(Theme.small(), shiftLabel.getText()));
        noiseLabel.setPreferredSize(new Dimension(longer + 2, Theme.px(20)));
        shiftLabel.setPreferredSize(new Dimension(longer + 2, Theme.px(20)));
        for (JLabel value : new JLabel[] {noiseValue, shiftValue}) {
            value.setFont(Theme.monoSmall());
            value.setForeground(Theme.color(Ink.TEXT));
            value.setHorizontalAlignment(SwingConstants.TRAILING);
            int width = Drawing.width(Theme.monoSmall(), "+10.0 %");
            value.setPreferredSize(new Dimension(width, Theme.px(20)));
        }
        verdict.setPreferredSize(new Dimension(Theme.px(100), Theme.px(22)));
        verdict.setMinimumSize(new Dimension(0, Theme.px(22)));
        reset.setIcon(Symbol.ERASE.icon(14));
        reset.setBorder(Theme.padding(0, 4, 0, 4));
        reset.setContentAreaFilled(false);
    }
}
