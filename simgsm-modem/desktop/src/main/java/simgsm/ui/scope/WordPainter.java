package simgsm.ui.scope;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simgsm.words.FrontEnd;
import simgsm.words.HeardWord;
import simgsm.words.SpeechFrame;
import simgsm.words.WordComparison;
import simgsm.words.WordComparison.WordDistance;

/**
 * Paints the spoken word that was compared last. At the left its mel bands, low ones at the bottom, louder is darker, and
 * over them the path of the match: to the right through the word, upwards through the nearest template. At the right the
 * distances of the nearest words, and a dashed line where the nearest one has to end.
 */
final class WordPainter {
    private static final int MOST_WORDS = 6;
    private static final double ROW_UNITS = 15;
    private static final double NAME_UNITS = 66;
    private static final double LABEL_POINTS = 9.5;
    /** Room for the frequencies at the left, and for the time below. */
    private static final double FREQUENCY_UNITS = 42;

    private static final double TIME_UNITS = 14;
    private static final double TICK_UNITS = 3;
    private static final int[] HERTZ = {250, 500, 1000, 2000, 3000};
    private static final double MILLIS_PER_FRAME = FrontEnd.SHIFT / 8.0;
    /** Part of the width with the bands. */
    private static final double BANDS = 0.55;
    /** Quieter bands are blank, in nepers below the loudest. */
    private static final double RANGE = 5.5;

    private final TextBundle texts;

    WordPainter(TextBundle texts) {
        this.texts = texts;
    }

    /** @param height without the line of the reading */
    void paint(Graphics2D g, Optional<WordComparison> word, double width, double height) {
        if (word.isEmpty()) {
            return;
        }
        double gutter = Theme.px(FREQUENCY_UNITS);
        Rectangle2D area = new Rectangle2D.Double(
                gutter, 0, Math.rint(width * BANDS) - gutter, Math.rint(height - Theme.exact(TIME_UNITS)));
        BufferedImage bands = bands(word.get().frames(), Theme.color(Ink.CARD), Theme.color(Ink.ACCENT));
        g.drawImage(bands, (int) gutter, 0, (int) area.getWidth(), (int) area.getHeight(), null);
        g.setColor(Theme.color(Ink.CONTROL_LINE));
        g.setStroke(Theme.hairline());
        g.draw(area);
        paintFrequencies(g, bands.getHeight(), area);
        paintTime(g, bands.getWidth() * MILLIS_PER_FRAME, area);
        paintPath(g, word.get().path(), area);
        double left = area.getMaxX() + Theme.exact(Theme.GRID);
        paintDistances(g, word.get(), left, width - left, height);
    }

    private static void paintFrequencies(Graphics2D g, int bands, Rectangle2D area) {
        var font = Theme.mono(LABEL_POINTS, false);
        g.setFont(font);
        g.setColor(Theme.color(Ink.QUIET));
        double tick = area.getX() - Theme.exact(TICK_UNITS);
        for (int hertz : HERTZ) {
            double y = area.getMaxY() - area.getHeight() * (FrontEnd.band(hertz) + 0.5) / bands;
            Drawing.horizontal(g, tick, area.getX(), y);
            String text = hertz < 1000 ? hertz + " Hz" : hertz / 1000 + " kHz";
            Drawing.rightAligned(g, text, tick - Theme.exact(2), y + Drawing.capHeight(g, font) / 2);
        }
    }

    /** Time from the beginning of the word, every 100, 200 ... ms as labels have room. */
    private static void paintTime(Graphics2D g, double millis, Rectangle2D area) {
        var font = Theme.mono(LABEL_POINTS, false);
        double room = Drawing.width(font, "1000 ms ");
        int step = 100;
        while (step * area.getWidth() / millis < room) {
            step *= 2;
        }
        for (int at = 0; at <= millis; at += step) {
            double x = area.getX() + area.getWidth() * at / millis;
            Drawing.vertical(g, x, area.getMaxY(), area.getMaxY() + Theme.exact(TICK_UNITS));
            Drawing.centred(g, at + " ms", font, x, area.getMaxY() + Theme.exact(TIME_UNITS - LABEL_POINTS / 2));
        }
    }

    private static BufferedImage bands(List<SpeechFrame> frames, Color quiet, Color loud) {
        int rows = frames.get(0).bands().length;
        double loudest = 0;
        for (SpeechFrame frame : frames) {
            for (float band : frame.bands()) {
                loudest = Math.max(loudest, Math.log(Math.max(1, band)));
            }
        }
        BufferedImage image = new BufferedImage(frames.size(), rows, BufferedImage.TYPE_INT_RGB);
        for (int x = 0; x < frames.size(); x++) {
            for (int band = 0; band < rows; band++) {
                double below = loudest - Math.log(Math.max(1, frames.get(x).bands()[band]));
                double share = Math.max(0, 1 - below / RANGE);
                image.setRGB(x, rows - 1 - band, SpectrogramPainter.between(quiet, loud, share));
            }
        }
        return image;
    }

    private static void paintPath(Graphics2D g, List<Double> path, Rectangle2D area) {
        Path2D line = new Path2D.Double();
        for (int i = 0; i < path.size(); i++) {
            double x = area.getX() + area.getWidth() * (i + 0.5) / path.size();
            double y = area.getHeight() * (1 - path.get(i));
            if (i == 0) {
                line.moveTo(x, y);
            } else {
                line.lineTo(x, y);
            }
        }
        g.setColor(Theme.color(Ink.CARD));
        g.setStroke(Theme.stroke(4));
        g.draw(line);
        g.setColor(Theme.color(Ink.WARNING));
        g.setStroke(Theme.stroke(2));
        g.draw(line);
    }

    private void paintDistances(Graphics2D g, WordComparison word, double x, double width, double height) {
        double row = Theme.exact(ROW_UNITS);
        int most = Math.max(2, Math.min(MOST_WORDS, (int) (height / row)));
        List<WordDistance> shown = word.distances().stream().limit(most).toList();
        double name = Math.min(Theme.exact(NAME_UNITS), width * 0.5);
        double longest = shown.get(shown.size() - 1).distance();
        double scale = (width - name) / longest;
        for (int i = 0; i < shown.size(); i++) {
            boolean isFirst = i == 0;
            double top = i * row;
            g.setColor(Theme.color(isFirst ? Ink.TEXT : Ink.QUIET));
            var font = Theme.mono(LABEL_POINTS + 1, isFirst);
            g.setFont(font);
            String text = Drawing.fitted(font, name(shown.get(i).word()), name - Theme.exact(4));
            g.drawString(text, (float) x, (float) (top + row * 0.72));
            Ink first = word.result().isSure() ? Ink.ACCENT : Ink.WARNING;
            g.setColor(Theme.color(isFirst ? first : Ink.CONTROL_LINE));
            Drawing.fillCrisp(g, x + name, top + row * 0.15, shown.get(i).distance() * scale, row * 0.7);
        }
        if (shown.size() > 1) {
            double limit = x + name + shown.get(1).distance() * HeardWord.MOST_RATIO * scale;
            g.setColor(Theme.color(Ink.DANGER));
            g.setStroke(Theme.dashed(1.3, 4));
            Drawing.line(g, limit, 0, limit, shown.size() * row);
        }
    }

    private String name(String word) {
        return texts.of("scope.word." + word);
    }

    /** The ear's reason in words. */
    String words(Optional<WordComparison> word) {
        if (word.isEmpty()) {
            return texts.of("scope.word.none");
        }
        HeardWord heard = word.get().result();
        List<WordDistance> distances = word.get().distances();
        boolean isAlone = distances.size() == 1;
        WordDistance second = distances.get(isAlone ? 0 : 1);
        String decision = isAlone ? "alone" : heard.isSure() ? "sure" : "refused";
        return texts.of(
                "scope.word." + (heard.hasItsLength() ? decision : "length"),
                name(heard.word()),
                number("%.1f", distances.get(0).distance()),
                name(second.word()),
                number("%.1f", second.distance()),
                number("%.2f", heard.ratio()),
                number("%.2f", HeardWord.MOST_RATIO));
    }

    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }
}
