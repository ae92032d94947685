package simgsm.cells.ui;

import simgsm.console.TextBundle;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;

/** The key to the map's densities, at its lower right. */
final class LevelLegend {
    private static final double BOX_UNITS = 32;
    private static final double HEIGHT_UNITS = 10;
    private static final int[] LEVELS_DBM = {-105, -95, -85, -75, -65, -55};

    private final TextBundle texts;

    LevelLegend(TextBundle texts) {
        this.texts = texts;
    }

    void draw(Canvas g, MapScale scale) {
        double box = g.px(BOX_UNITS);
        double left = scale.left() + scale.width() - g.px(12) - LEVELS_DBM.length * box;
        double top = scale.top() + scale.height() - g.px(12) - g.px(HEIGHT_UNITS);
        if (left < scale.left() + scale.width() * 0.6) {
            return;
        }
        g.ink(Ink.CARD, 0.85);
        g.fill(Outline.round(left - g.px(34), top - g.px(18), LEVELS_DBM.length * box + g.px(42), g.px(36), g.px(4)));
        for (int i = 0; i < LEVELS_DBM.length; i++) {
            g.ink(Ink.FLOOR);
            g.bar(left + i * box, top, box, g.px(HEIGHT_UNITS));
            g.ink(Ink.TEXT, CoverageImage.density(LEVELS_DBM[i]));
            g.bar(left + i * box, top, box, g.px(HEIGHT_UNITS));
        }
        g.ink(Ink.TEXT);
        g.text(texts.of("map.levels"), Face.SMALL, left - g.px(16), top + g.px(HEIGHT_UNITS / 2));
        for (int i = 1; i < LEVELS_DBM.length; i++) {
            int dbm = LEVELS_DBM[i] - CoverageImage.STEP_DECIBELS / 2;
            g.text(String.valueOf(dbm), Face.SMALL, left + i * box, top - g.px(8));
        }
    }
}
