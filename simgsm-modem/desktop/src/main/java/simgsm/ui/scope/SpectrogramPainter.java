package simgsm.ui.scope;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfKey;
import simgsm.scope.ScopeInstrument;
import simgsm.scope.SoundStretch;
import simgsm.scope.Spectrogram;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

/**
 * Paints the last 2 s of a sound: time to the right, frequency upwards, louder is darker; lines at the eight tones.
 */
final class SpectrogramPainter {
    private static final double LABEL_POINTS = 9.5;
    private static final int ROWS = 96;
    private static final double TOP_DBM0 = -6;

    private SoundStretch drawn;
    private Color drawnInk;
    private BufferedImage picture;

    void paint(Graphics2D g, SoundStretch sound, Rectangle2D area) {
        Color ink = Theme.color(Ink.ACCENT);
        if (sound != drawn || !ink.equals(drawnInk)) {
            picture = picture(sound, Theme.color(Ink.CARD), ink);
            drawn = sound;
            drawnInk = ink;
        }
        g.drawImage(picture, (int) area.getX(), (int) area.getY(), (int) area.getWidth(), (int) area.getHeight(), null);
        paintTones(g, area);
        g.setColor(Theme.color(Ink.CONTROL_LINE));
        g.setStroke(Theme.hairline());
        g.draw(area);
    }

    private static BufferedImage picture(SoundStretch sound, Color quiet, Color loud) {
        Spectrogram spectrogram = new Spectrogram(sound.last(SoundStretch.SAMPLES));
        double step = (ScopeInstrument.MOST_HERTZ - ScopeInstrument.LEAST_HERTZ) / ROWS;
        BufferedImage image = new BufferedImage(spectrogram.columns(), ROWS, BufferedImage.TYPE_INT_RGB);
        for (int x = 0; x < spectrogram.columns(); x++) {
            for (int y = 0; y < ROWS; y++) {
                double hertz = ScopeInstrument.MOST_HERTZ - (y + 0.5) * step;
                double share =
                        (spectrogram.dbm0(x, hertz) - Spectrogram.FLOOR_DBM0) / (TOP_DBM0 - Spectrogram.FLOOR_DBM0);
                image.setRGB(x, y, between(quiet, loud, Math.min(1, share)));
            }
        }
        return image;
    }

    static int between(Color a, Color b, double share) {
        int red = (int) Math.round(a.getRed() + share * (b.getRed() - a.getRed()));
        int green = (int) Math.round(a.getGreen() + share * (b.getGreen() - a.getGreen()));
        int blue = (int) Math.round(a.getBlue() + share * (b.getBlue() - a.getBlue()));
        return red << 16 | green << 8 | blue;
    }

    /** Labels the eight frequencies at the left, if they fit. */
    private static void paintTones(Graphics2D g, Rectangle2D area) {
        var font = Theme.mono(LABEL_POINTS, false);
        g.setFont(font);
        double last = Double.NEGATIVE_INFINITY;
        for (int tone = 7; tone >= 0; tone--) {
            double hertz = tone < 4
                    ? DtmfKey.at(tone, 0).rowHertz()
                    : DtmfKey.at(0, tone - 4).columnHertz();
            double y = y(area, hertz);
            g.setColor(Theme.color(Ink.CONTROL_LINE, 0.5));
            Drawing.horizontal(g, area.getX(), area.getMaxX(), y);
            if (y - last >= Theme.exact(LABEL_POINTS)) {
                g.setColor(Theme.color(Ink.QUIET));
                Drawing.rightAligned(
                        g,
                        String.valueOf((int) hertz),
                        area.getX() - Theme.exact(4),
                        y + Theme.exact(LABEL_POINTS) * 0.36);
                last = y;
            }
        }
    }

    static double y(Rectangle2D area, double hertz) {
        return area.getMaxY()
                - area.getHeight()
                        * (hertz - ScopeInstrument.LEAST_HERTZ)
                        / (ScopeInstrument.MOST_HERTZ - ScopeInstrument.LEAST_HERTZ);
    }
}
