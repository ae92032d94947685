package simgsm.ui;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.Locale;
import java.util.Optional;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.ToneTrace;
import simgsm.ui.Theme.Ink;

/**
 * Paints a {@link ToneTrace}: the wave above, below it the eight levels and the key matrix, and one line of numbers.
 *
 * <pre>
 *   +---------------------------+
 *   |  wave, 24 ms              |
 *   +------------------+--------+
 *   | 4 rows | 4 cols  | matrix |
 *   +------------------+--------+
 *   | # -10.2/-10.4 dBm0 ...    |
 * </pre>
 */
public final class ToneScopePainter {
    private static final int SHOWN_SAMPLES = 192;
    private static final double TOP_DBM0 = 0;
    private static final double BOTTOM_DBM0 = -48;
    private static final double FULL_SCALE = 32768;

    private final Texts texts;

    public ToneScopePainter(Locale language) {
        texts = Messages.in(language);
    }

    /** @param width of the box that starts at the origin, in pixels */
    public void paint(Graphics2D g, ToneTrace trace, double width, double height) {
        double gap = Theme.exact(Theme.GRID);
        double lineHeight = Theme.exact(18);
        double waveHeight = Math.max(Theme.exact(32), (height - lineHeight - gap) * 0.44);
        double bottom = height - lineHeight;
        double barsTop = waveHeight + gap;
        double matrix = Math.min(bottom - barsTop, width * 0.3);
        paintWave(g, trace, width, waveHeight);
        paintBars(g, trace, 0, barsTop, width - matrix - 2 * gap, bottom - barsTop);
        paintMatrix(g, trace, width - matrix, barsTop + (bottom - barsTop - matrix) / 2, matrix);
        paintReading(g, trace, width, height);
    }

    private static void paintWave(Graphics2D g, ToneTrace trace, double width, double height) {
        g.setColor(Ink.LINE.color());
        for (int i = 0; i <= 8; i++) {
            Drawing.vertical(g, (width - Theme.exact(1)) * i / 8, 0, height);
        }
        for (int i = 0; i <= 4; i++) {
            Drawing.horizontal(g, 0, width, (height - Theme.exact(1)) * i / 4);
        }
        var wave = new Path2D.Double();
        int start = trigger(trace);
        for (int i = 0; i < SHOWN_SAMPLES; i++) {
            double x = width * i / (SHOWN_SAMPLES - 1);
            double y = height / 2 * (1 - trace.sample(start + i) / FULL_SCALE * 1.6);
            y = Math.max(1, Math.min(height - 1, y));
            if (i == 0) {
                wave.moveTo(x, y);
            } else {
                wave.lineTo(x, y);
            }
        }
        g.setColor(Ink.ACCENT.color());
        g.setStroke(Theme.stroke(1.4));
        g.draw(wave);
    }

    /** Starts the picture where the wave rises through zero, so that it stands still. */
    private static int trigger(ToneTrace trace) {
        for (int i = 1; i <= ToneTrace.SAMPLES - SHOWN_SAMPLES; i++) {
            if (trace.sample(i - 1) < 0 && trace.sample(i) >= 0) {
                return i;
            }
        }
        return 0;
    }

    private static void paintBars(Graphics2D g, ToneTrace trace, double x, double y, double width, double height) {
        double labels = Theme.exact(14);
        double tall = height - labels;
        double groupGap = Theme.exact(10);
        double step = (width - groupGap) / 8;
        g.setColor(Ink.LINE.color());
        Drawing.horizontal(g, x, x + width, y + tall);
        for (int i = 0; i < 8; i++) {
            double left = x + i * step + (i >= 4 ? groupGap : 0);
            double dbm0 = i < 4 ? trace.rowDbm0(i) : trace.columnDbm0(i - 4);
            boolean strongest = isStrongest(trace, i);
            double share = Math.max(0, Math.min(1, (dbm0 - BOTTOM_DBM0) / (TOP_DBM0 - BOTTOM_DBM0)));
            g.setColor(Ink.LINE.color(0.45));
            Drawing.fillCrisp(g, left + step * 0.16, y, step * 0.68, tall);
            g.setColor((strongest ? Ink.ACCENT : Ink.QUIET).color());
            Drawing.fillCrisp(g, left + step * 0.16, y + tall * (1 - share), step * 0.68, tall * share);
            g.setColor((strongest ? Ink.TEXT : Ink.QUIET).color());
            String label = hertz(i);
            var font = Theme.mono(Math.min(10, step / Theme.zoom() * 0.36), strongest);
            Drawing.centred(g, label, font, left + step / 2, y + tall + labels * 0.62);
        }
    }

    private static String hertz(int index) {
        double hertz = index < 4
                ? DtmfKey.at(index, 0).rowHertz()
                : DtmfKey.at(0, index - 4).columnHertz();
        return String.valueOf((int) hertz);
    }

    /** Whether this frequency is the loudest of its group and loud enough to be a tone. */
    private static boolean isStrongest(ToneTrace trace, int index) {
        double own = index < 4 ? trace.rowDbm0(index) : trace.columnDbm0(index - 4);
        for (int i = 0; i < 4; i++) {
            if ((index < 4 ? trace.rowDbm0(i) : trace.columnDbm0(i)) > own) {
                return false;
            }
        }
        return own > BOTTOM_DBM0 + 6;
    }

    private static void paintMatrix(Graphics2D g, ToneTrace trace, double x, double y, double size) {
        double step = size / 4;
        Optional<DtmfKey> key = trace.digit().map(DtmfDigit::key);
        for (DtmfKey each : DtmfKey.values()) {
            double left = x + each.column() * step;
            double top = y + each.row() * step;
            boolean last = key.isPresent() && key.get() == each;
            var cell = Drawing.round(left + 1, top + 1, step - 2, step - 2, Theme.exact(3));
            if (last) {
                g.setColor((trace.isSounding() ? Ink.ACCENT : Ink.ACCENT_WASH).color());
                g.fill(cell);
            }
            g.setColor((last ? Ink.ACCENT : Ink.LINE).color());
            g.setStroke(Theme.hairline());
            g.draw(cell);
            Ink ink = last ? trace.isSounding() ? Ink.ON_ACCENT : Ink.TEXT : Ink.QUIET;
            g.setColor(ink.color());
            var font = Theme.mono(step / Theme.zoom() * 0.55, last);
            Drawing.centred(g, String.valueOf(each.symbol()), font, left + step / 2, top + step / 2);
        }
    }

    private void paintReading(Graphics2D g, ToneTrace trace, double width, double height) {
        String text =
                trace.digit().map(digit -> reading("scope.reading", digit)).orElseGet(() -> texts.of("scope.idle"));
        g.setColor((trace.digit().isPresent() ? Ink.TEXT : Ink.QUIET).color());
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
    String spoken(ToneTrace trace) {
        return trace.digit().map(digit -> reading("scope.spoken", digit)).orElseGet(() -> texts.of("scope.name"));
    }

    private String reading(String key, DtmfDigit digit) {
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
