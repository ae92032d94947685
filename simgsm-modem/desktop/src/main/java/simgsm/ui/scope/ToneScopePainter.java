package simgsm.ui.scope;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneLevels;
import simgsm.scope.ReceiverTrace;
import simgsm.scope.ScopeInstrument;
import simgsm.scope.ScopeInstrument.Picture;
import simgsm.scope.ToneTrace;
import simgsm.tone.ToneExperiment;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/**
 * Paints a {@link ToneTrace}: the wave above, below it the eight levels with their thresholds, the key matrix, and
 * one line of numbers; or its spectrogram. A wave changed by an experiment has another colour and shows the
 * experiment's values.
 * <pre>
 *   +---------------------------+
 *   |  wave, 24 ms              |
 *   +------------------+--------+
 *   | 4 rows | 4 cols  | matrix |
 *   +------------------+--------+
 *   | # -10.2/-10.4 dBm0 ...    |
 * </pre>
 */
final class ToneScopePainter {
    private static final int SHOWN_SAMPLES = 192;
    private static final double TOP_DBM0 = 0;
    private static final double BOTTOM_DBM0 = ToneLevels.FLOOR_DBM0;
    private static final double FULL_SCALE = 32768;
    /** Tones of -10 dBm0 fill most of the height. */
    private static final double WAVE_GAIN = 1.6;

    /** The frequencies below the bars; if they are too wide, every other one is a line lower. */
    private static final double LABEL_POINTS = 10;

    private static final double LINE_UNITS = 18;
    private static final double SCALE_UNITS = 23;
    private static final double FREQUENCY_UNITS = 32;
    private static final double GROUP_GAP_UNITS = 10;

    private final TextBundle texts;
    private final SpectrogramPainter spectrogram = new SpectrogramPainter();
    private final WordPainter word;

    ToneScopePainter(Locale language) {
        texts = DesktopTexts.in(language);
        word = new WordPainter(texts);
    }

    /**
     * Paints the state of an instrument.
     *
     * @param shown the receiver of the levels, limits and last key
     * @param width of the box at the origin, in pixels
     */
    void paint(Graphics2D g, ScopeInstrument instrument, ReceiverTrace shown, double width, double height) {
        ToneTrace trace = instrument.trace();
        boolean isHiding = instrument.isHiding();
        Rectangle2D area = area(instrument, width, height);
        if (instrument.picture() == Picture.SPECTROGRAM) {
            spectrogram.paint(g, trace.heard(), area);
        } else if (instrument.picture() == Picture.WORD) {
            word.paint(g, trace.word(), width, height - Theme.exact(LINE_UNITS) - Theme.exact(4));
        } else {
            boolean comparing = instrument.isComparing();
            Rectangle2D keys = keys(width, height);
            double barsTop = area.getMaxY() + Theme.exact(Theme.GRID);
            double scale = Theme.exact(SCALE_UNITS);
            paintWave(g, trace, comparing, width, area.getHeight());
            double barsWidth = keys.getX() - 2 * Theme.exact(Theme.GRID) - scale;
            double barsHeight = height - Theme.exact(LINE_UNITS) - barsTop;
            paintBars(g, shown.levels(), scale, barsTop, barsWidth, barsHeight);
            if (comparing) {
                paintLevelsBefore(g, trace.originalLevels(), scale, barsTop, barsWidth, barsHeight);
            }
            paintMatrix(g, isHiding ? Optional.empty() : shown.digit().map(DtmfDigit::key), shown.isSounding(), keys);
        }
        if (instrument.hasCursors()) {
            double span = instrument.picture() == Picture.SPECTROGRAM
                    ? ScopeInstrument.SPECTROGRAM_MILLIS
                    : ScopeInstrument.WAVE_MILLIS;
            CursorPainter.paint(g, instrument.cursors(), area, span);
        }
        paintReading(
                g,
                reading(instrument, shown),
                instrument.hasCursors() || shown.digit().isPresent(),
                width,
                height);
        if (instrument.isFrozen()) {
            paintFlag(g, texts.of("scope.frozen"), Ink.ACCENT, width, Theme.exact(3));
        }
    }

    /** The area of the cursors: the wave, or the whole spectrogram. */
    Rectangle2D area(ScopeInstrument instrument, double width, double height) {
        double line = Theme.exact(LINE_UNITS);
        if (instrument.picture() == Picture.SPECTROGRAM) {
            double left = Theme.exact(FREQUENCY_UNITS);
            return new Rectangle2D.Double(left, 0, width - left - 1, height - line - Theme.exact(4));
        }
        double waveHeight = Math.max(Theme.exact(32), (height - line - Theme.exact(Theme.GRID)) * 0.4);
        return new Rectangle2D.Double(0, 0, width, waveHeight);
    }

    /** The matrix of keys in {@link Picture#LEVELS}. */
    Rectangle2D keys(double width, double height) {
        double line = Theme.exact(LINE_UNITS);
        double gap = Theme.exact(Theme.GRID);
        double waveHeight = Math.max(Theme.exact(32), (height - line - gap) * 0.4);
        double top = waveHeight + gap;
        double side = Math.min(height - line - top, width * 0.3);
        return new Rectangle2D.Double(width - side, top + (height - line - top - side) / 2, side, side);
    }

    private void paintWave(Graphics2D g, ToneTrace trace, boolean comparing, double width, double height) {
        g.setColor(Theme.color(Ink.LINE));
        for (int i = 0; i <= 8; i++) {
            Drawing.vertical(g, (width - Theme.exact(1)) * i / 8, 0, height);
        }
        for (int i = 0; i <= 4; i++) {
            Drawing.horizontal(g, 0, width, (height - Theme.exact(1)) * i / 4);
        }
        boolean changed = !trace.experiment().equals(ToneExperiment.NONE);
        short[] after = trace.heard().last(ToneTrace.SAMPLES);
        int start = trigger(after);
        if (comparing) {
            g.setColor(Theme.color(Ink.QUIET));
            g.setStroke(Theme.dashed(1.2, 3));
            g.draw(wave(trace.original().last(ToneTrace.SAMPLES), start, width, height));
        }
        g.setColor(Theme.color(changed ? Ink.WARNING : Ink.ACCENT));
        g.setStroke(Theme.stroke(1.4));
        g.draw(wave(after, start, width, height));
        if (changed) {
            paintFlag(g, trial(trace.experiment()), Ink.WARNING, width, height - Theme.exact(19));
        }
    }

    /** A short line across each bar at the level before the experiment. */
    private static void paintLevelsBefore(
            Graphics2D g, ToneLevels levels, double x, double y, double width, double height) {
        double groupGap = Theme.exact(GROUP_GAP_UNITS);
        double step = (width - groupGap) / 8;
        double tall = barHeight(step, height);
        g.setColor(Theme.color(Ink.TEXT));
        for (int i = 0; i < 8; i++) {
            double left = x + i * step + (i >= 4 ? groupGap : 0);
            double at = y + tall * (1 - share(levels.dbm0(i)));
            Drawing.fillCrisp(g, left, at - Theme.exact(1), step, Theme.exact(2));
        }
    }

    private static Path2D wave(short[] samples, int start, double width, double height) {
        var wave = new Path2D.Double();
        for (int i = 0; i < SHOWN_SAMPLES; i++) {
            double x = width * i / (SHOWN_SAMPLES - 1);
            double y = height / 2 * (1 - samples[start + i] / FULL_SCALE * WAVE_GAIN);
            y = Math.max(1, Math.min(height - 1, y));
            if (i == 0) {
                wave.moveTo(x, y);
            } else {
                wave.lineTo(x, y);
            }
        }
        return wave;
    }

    /** The first sample at which the wave rises through zero, for a steady picture. */
    private static int trigger(short[] samples) {
        for (int i = 1; i <= ToneTrace.SAMPLES - SHOWN_SAMPLES; i++) {
            if (samples[i - 1] < 0 && samples[i] >= 0) {
                return i;
            }
        }
        return 0;
    }

    /** Words in the corner of the wave: the experiment's values, since the wave is not the call's; or "frozen". */
    private static void paintFlag(Graphics2D g, String text, Ink ink, double width, double top) {
        var font = Theme.monoSmall();
        double textWidth = Drawing.width(font, text);
        double height = Theme.exact(16);
        double left = width - textWidth - Theme.exact(13);
        g.setColor(Theme.color(ink == Ink.WARNING ? Ink.WARNING_WASH : Ink.ACCENT_WASH));
        var flag = Drawing.round(left, top, textWidth + Theme.exact(10), height, Theme.exact(3));
        g.fill(flag);
        g.setColor(Theme.color(ink));
        g.setStroke(Theme.hairline());
        g.draw(flag);
        Drawing.centred(g, text, font, left + Theme.exact(5) + textWidth / 2, top + height / 2);
    }

    private String trial(ToneExperiment experiment) {
        List<String> changes = new ArrayList<>();
        if (experiment.hasNoise()) {
            changes.add(decimal("SNR %.0f dB", experiment.snrDecibels()));
        }
        if (experiment.shiftPercent() != 0) {
            changes.add(decimal("%+.1f", experiment.shiftPercent()) + " %");
        }
        experiment.codec().ifPresent(kind -> changes.add(CodecText.name(texts, kind)));
        return texts.of("scope.trial", String.join(", ", changes));
    }

    private static void paintBars(Graphics2D g, ToneLevels levels, double x, double y, double width, double height) {
        double groupGap = Theme.exact(GROUP_GAP_UNITS);
        double step = (width - groupGap) / 8;
        double line = Theme.exact(LABEL_POINTS + 3);
        boolean staggered = isStaggered(step);
        double points = Math.min(LABEL_POINTS, step / Theme.zoom() * 0.75);
        double tall = barHeight(step, height);
        paintScale(g, x, y, width, tall);
        for (int i = 0; i < 8; i++) {
            double left = x + i * step + (i >= 4 ? groupGap : 0);
            boolean counts = levels.counts(i);
            double share = share(levels.dbm0(i));
            g.setColor(Theme.color(Ink.LINE, 0.45));
            Drawing.fillCrisp(g, left + step * 0.16, y, step * 0.68, tall);
            g.setColor(Theme.color(counts ? Ink.ACCENT : Ink.QUIET));
            Drawing.fillCrisp(g, left + step * 0.16, y + tall * (1 - share), step * 0.68, tall * share);
            g.setColor(Theme.color(counts ? Ink.TEXT : Ink.QUIET));
            double below = staggered && i % 2 == 1 ? 1.55 : 0.58;
            Drawing.centred(g, hertz(i), Theme.mono(points, counts), left + step / 2, y + tall + line * below);
        }
        paintThreshold(g, levels.leastDbm0(0), x, y, 4 * step, tall);
        paintThreshold(g, levels.leastDbm0(4), x + 4 * step + groupGap, y, 4 * step, tall);
    }

    private static boolean isStaggered(double step) {
        return Drawing.width(Theme.mono(LABEL_POINTS, true), "1633") > step - Theme.exact(4);
    }

    private static double barHeight(double step, double height) {
        return height - (isStaggered(step) ? 2 : 1) * Theme.exact(LABEL_POINTS + 3);
    }

    /** The levels of the scale in dBm0, as lines behind the bars. */
    private static void paintScale(Graphics2D g, double x, double y, double width, double tall) {
        var font = Theme.mono(9.5, false);
        double last = Double.NEGATIVE_INFINITY;
        for (int dbm0 = (int) TOP_DBM0; dbm0 >= BOTTOM_DBM0; dbm0 -= 20) {
            double at = y + tall * (1 - share(dbm0));
            g.setColor(Theme.color(Ink.LINE));
            Drawing.horizontal(g, x - Theme.exact(3), x + width, at);
            if (at - last >= Theme.exact(9)) {
                last = at;
                g.setColor(Theme.color(Ink.QUIET));
                g.setFont(font);
                Drawing.rightAligned(
                        g, String.valueOf(dbm0).replace('-', '\u2212'), x - Theme.exact(4), at + Theme.exact(3));
            }
        }
    }

    /** The least level of the group's tones: a dashed line across its four bars. */
    private static void paintThreshold(Graphics2D g, double dbm0, double x, double y, double width, double tall) {
        double at = y + tall * (1 - share(dbm0));
        g.setColor(Theme.color(Ink.DANGER));
        g.setStroke(Theme.dashed(1.3, 4));
        Drawing.line(g, x, at, x + width, at);
    }

    private static double share(double dbm0) {
        return Math.max(0, Math.min(1, (dbm0 - BOTTOM_DBM0) / (TOP_DBM0 - BOTTOM_DBM0)));
    }

    private static String hertz(int index) {
        double hertz = index < 4
                ? DtmfKey.at(index, 0).rowHertz()
                : DtmfKey.at(0, index - 4).columnHertz();
        return String.valueOf((int) hertz);
    }

    private static void paintMatrix(Graphics2D g, Optional<DtmfKey> key, boolean isSounding, Rectangle2D box) {
        double step = box.getWidth() / 4;
        for (DtmfKey each : DtmfKey.values()) {
            double left = box.getX() + each.column() * step;
            double top = box.getY() + each.row() * step;
            boolean last = key.isPresent() && key.get() == each;
            var cell = Drawing.round(left + 1, top + 1, step - 2, step - 2, Theme.exact(3));
            if (last) {
                g.setColor(Theme.color(isSounding ? Ink.ACCENT : Ink.ACCENT_WASH));
                g.fill(cell);
            }
            g.setColor(Theme.color(last ? Ink.ACCENT : Ink.LINE));
            g.setStroke(Theme.hairline());
            g.draw(cell);
            Ink ink = last ? isSounding ? Ink.ON_ACCENT : Ink.TEXT : Ink.QUIET;
            g.setColor(Theme.color(ink));
            var font = Theme.mono(step / Theme.zoom() * 0.55, last);
            Drawing.centred(g, String.valueOf(each.symbol()), font, left + step / 2, top + step / 2);
        }
    }

    /** Reading of the cursors, or of the last key. */
    private String reading(ScopeInstrument instrument, ReceiverTrace shown) {
        if (instrument.hasCursors()) {
            return CursorPainter.words(texts, instrument.cursors());
        }
        if (instrument.isHiding()) {
            return texts.of("scope.hidden");
        }
        if (instrument.picture() == Picture.WORD) {
            return word.words(instrument.trace().word());
        }
        return shown.digit().map(digit -> reading("scope.reading", digit)).orElseGet(() -> texts.of("scope.idle"));
    }

    private static void paintReading(Graphics2D g, String text, boolean isStrong, double width, double height) {
        g.setColor(Theme.color(isStrong ? Ink.TEXT : Ink.QUIET));
        var font = Theme.monoSmall();
        g.setFont(font);
        double natural = g.getFontMetrics().stringWidth(text);
        if (natural > width) {
            font = font.deriveFont((float) (font.getSize2D() * width / natural));
            g.setFont(font);
        }
        g.drawString(text, 0, (float) (height - Theme.exact(3)));
    }

    /** The numbers in words, for assistive technology. */
    String spoken(ScopeInstrument instrument, ReceiverTrace shown) {
        if (instrument.hasCursors()) {
            return texts.of("scope.name") + ": " + CursorPainter.words(texts, instrument.cursors());
        }
        if (instrument.isHiding()) {
            return texts.of("scope.name") + ": " + texts.of("scope.hidden");
        }
        if (instrument.picture() == Picture.WORD) {
            return texts.of("scope.name") + ": " + word.words(instrument.trace().word());
        }
        return shown.digit().map(digit -> reading("scope.spoken", digit)).orElseGet(() -> texts.of("scope.name"));
    }

    private String reading(String key, DtmfDigit digit) {
        if (!digit.isMeasured()) {
            String symbol = String.valueOf(digit.key().symbol());
            return digit.durationSamples() == 0
                    ? texts.of("scope.reported", symbol)
                    : texts.of("scope.reported.long", symbol, decimal("%.0f", digit.durationMillis()));
        }
        return texts.of(
                key,
                String.valueOf(digit.key().symbol()),
                decimal("%.1f", digit.rowDbm0()),
                decimal("%.1f", digit.columnDbm0()),
                decimal("%+.1f", digit.twistDecibels()),
                decimal("%+.1f", digit.frequencyErrorPercent()),
                decimal("%.0f", digit.durationMillis()));
    }

    private static String decimal(String format, double value) {
        String text = String.format(Locale.ROOT, format, value);
        return text.matches("-0(\\.0*)?") ? "+" + text.substring(1) : text;
    }
}
