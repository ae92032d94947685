package simgsm.phone.ui;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.Drawing;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;

/** Paints a key of the handset: its face, lower edge, symbol and letters. */
final class PhoneKeyPainter {
    /** The current state of the key. @param unread messages, which key 1 shows */
    record Look(boolean down, boolean sounding, boolean rollover, boolean focused, int unread) {}

    private final PhoneKey key;
    private final TextBundle texts;

    PhoneKeyPainter(PhoneKey key, TextBundle texts) {
        this.key = key;
        this.texts = texts;
    }

    void paint(Graphics2D g, double width, double height, Look look) {
        double unit = height / HandsetLayout.heightOf(key);
        if (isPad()) {
            paintPad(g, width, height, unit, look);
        } else {
            paintCap(g, width, height, unit, look);
        }
    }

    private boolean isPad() {
        return switch (key) {
            case UP, DOWN, LEFT, RIGHT, OK -> true;
            default -> false;
        };
    }

    private void paintCap(Graphics2D g, double width, double height, double unit, Look look) {
        double radius = Theme.KEY_RADIUS * unit;
        double edge = 2.5 * unit;
        double drop = look.down ? 1.5 * unit : 0;
        g.setColor(Theme.color(lower()));
        g.fill(Drawing.round(0.5, 0.5 + drop, width - 1, height - 1 - drop, radius));
        g.setColor(Theme.color(face(look)));
        g.fill(Drawing.round(1.2, 1.2 + drop, width - 2.4, height - 2.4 - edge, radius - 0.7));
        if (look.sounding || look.focused) {
            g.setColor(Theme.color(Ink.ACCENT));
            g.setStroke(Theme.stroke(2 * unit / Theme.zoom()));
            g.draw(Drawing.round(1.5, 1.5 + drop, width - 3, height - 3 - drop, radius - 1));
        }
        double middle = (height - edge) / 2 + drop;
        g.setColor(Theme.color(sign()));
        switch (key) {
            case CALL -> Symbol.CALL.paint(g, width / 2, middle, 24 * unit);
            case END -> Symbol.HANG_UP.paint(g, width / 2, middle, 24 * unit);
            case MESSAGE -> labelled(g, Symbol.ENVELOPE, "key.message.label", width, middle, unit);
            case MENU -> Symbol.MENU.paint(g, width / 2, middle, 16 * unit);
            case CLEAR -> Drawing.centred(g, "C", Theme.sans(13.5 * unit / Theme.zoom(), true), width / 2, middle);
            case SOFT_LEFT, SOFT_RIGHT -> softMark(g, width, middle, unit);
            default -> paintDigit(g, width, middle, unit, look.unread);
        }
    }

    private Ink lower() {
        return switch (key) {
            case CALL -> Ink.CALL_FACE;
            case END -> Ink.END_FACE;
            default -> Ink.KEY_LINE;
        };
    }

    private Ink face(Look look) {
        return switch (key) {
            case CALL -> Ink.CALL_FACE;
            case END -> Ink.END_FACE;
            default ->
                look.sounding
                        ? Ink.ACCENT_WASH
                        : look.down ? Ink.PRESSED : look.rollover ? Ink.KEY_HOVER : Ink.KEY_FACE;
        };
    }

    private Ink sign() {
        return key == PhoneKey.CALL || key == PhoneKey.END ? Ink.ON_FACE : Ink.TEXT;
    }

    /** A short bar under the word on the display. */
    private static void softMark(Graphics2D g, double width, double middle, double unit) {
        g.fill(Drawing.round(width / 2 - 13 * unit, middle - 2 * unit, 26 * unit, 4 * unit, 2 * unit));
    }

    private void labelled(Graphics2D g, Symbol symbol, String textKey, double width, double middle, double unit) {
        String text = texts.of(textKey);
        var font = Theme.sans(12.5 * unit / Theme.zoom(), false);
        double icon = 16 * unit;
        double gap = 7 * unit;
        double textWidth = Drawing.width(font, text);
        double left = (width - icon - gap - textWidth) / 2;
        symbol.paint(g, left + icon / 2, middle, icon);
        Drawing.centred(g, text, font, left + icon + gap + textWidth / 2, middle);
    }

    private void paintDigit(Graphics2D g, double width, double middle, double unit, int unread) {
        String symbol = key.tone().map(tone -> String.valueOf(tone.symbol())).orElseThrow();
        double points = symbol.equals("*") ? 27 : 22;
        double drop = symbol.equals("*") ? 4 * unit : 0;
        boolean plain = key.letters().isEmpty() && key != PhoneKey.ONE;
        double x = plain ? width / 2 : width * 0.33;
        Drawing.centred(g, symbol, Theme.mono(points * unit / Theme.zoom(), true), x, middle + drop);
        g.setColor(Theme.color(Ink.QUIET));
        if (key == PhoneKey.ONE) {
            envelope(g, width * 0.66, middle, unit, unread);
        } else if (!plain) {
            Drawing.centred(g, key.letters(), Theme.sans(13 * unit / Theme.zoom(), false), width * 0.66, middle);
        }
    }

    /** The envelope; with unread messages it has the accent colour and their number at its right. */
    private static void envelope(Graphics2D g, double x, double y, double unit, int unread) {
        if (unread == 0) {
            Symbol.ENVELOPE.paint(g, x, y, 17 * unit);
            return;
        }
        g.setColor(Theme.color(Ink.ACCENT));
        Symbol.ENVELOPE.paint(g, x - 5 * unit, y, 19 * unit);
        String count = unread > 9 ? "9+" : String.valueOf(unread);
        Drawing.centred(g, count, Theme.mono(13 * unit / Theme.zoom(), true), x + 15 * unit, y);
    }

    private void paintPad(Graphics2D g, double width, double height, double unit, Look look) {
        Ink fill = look.down ? Ink.PRESSED : look.rollover ? Ink.KEY_HOVER : Ink.KEY_FACE;
        boolean centre = key == PhoneKey.OK;
        var shape = centre ? Drawing.round(0.5, 0.5, width - 1, height - 1, 8 * unit) : null;
        if (centre) {
            g.setColor(Theme.color(fill));
            g.fill(shape);
            g.setColor(Theme.color(look.focused ? Ink.ACCENT : Ink.KEY_LINE));
            g.setStroke(Theme.stroke((look.focused ? 2 : 1) * unit / Theme.zoom()));
            g.draw(shape);
        } else if (look.down || look.rollover || look.focused) {
            g.setColor(look.focused && !look.down ? Theme.color(Ink.ACCENT_WASH) : Theme.color(fill));
            g.fill(Drawing.round(2, 2, width - 4, height - 4, 7 * unit));
        }
        g.setColor(Theme.color(centre ? Ink.TEXT : Ink.QUIET));
        if (centre) {
            Drawing.centred(g, "OK", Theme.sans(11.5 * unit / Theme.zoom(), true), width / 2, height / 2);
        } else {
            arrow(g, width / 2, height / 2, unit);
        }
    }

    private void arrow(Graphics2D g, double x, double y, double unit) {
        double r = 5 * unit;
        var path = new Path2D.Double();
        switch (key) {
            case UP -> triangle(path, x, y - r * 0.6, r, 0.75 * r, false);
            case DOWN -> triangle(path, x, y + r * 0.6, r, -0.75 * r, false);
            case LEFT -> triangle(path, x - r * 0.6, y, r, 0.75 * r, true);
            default -> triangle(path, x + r * 0.6, y, r, -0.75 * r, true);
        }
        g.fill(path);
    }

    /** A triangle with its tip at (x, y); half its base is {@code half}, its height 1.6 {@code length}. */
    private static void triangle(Path2D path, double x, double y, double half, double length, boolean sideways) {
        path.moveTo(x, y);
        if (sideways) {
            path.lineTo(x + 1.6 * length, y - half);
            path.lineTo(x + 1.6 * length, y + half);
        } else {
            path.lineTo(x - half, y + 1.6 * length);
            path.lineTo(x + half, y + 1.6 * length);
        }
        path.closePath();
    }
}
