package simgsm.ui;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.util.Arrays;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.Painter;
import javax.swing.SwingUtilities;
import javax.swing.UIDefaults;
import simgsm.draw.Ink;

/**
 * Paints one region of a Nimbus component in one set of states: a fill, a thin line, a ring for the focus, or a mark such as
 * an arrow or a tick.
 */
record FlatPainter(Kind kind, List<String> states) implements Painter<JComponent> {
    /** As much of a box lies outside its part of a spinner. */
    private static final double JOINT_UNITS = 8;

    enum Kind {
        BUTTON,
        FIELD_FILL,
        LINED_FIELD,
        /** The upper half of the box at the right of a spinner's field. */
        SPINNER_NEXT,
        SPINNER_PREVIOUS,
        FIELD,
        AREA,
        CHECK,
        RADIO,
        TICK_ITEM,
        THUMB,
        SLIDER_TRACK,
        SLIDER_THUMB,
        NOTHING,
        ARROW_DOWN,
        /** Rotated by Synth to the direction of the arrow button. */
        ARROW_LEFT,
        ARROW_UP,
        TAB,
        TAB_LINE,
        HEADER,
        ITEM,
        POPUP,
        BAR,
        PROGRESS_TRACK,
        PROGRESS,
        RULE,
        FRAME,
        GRIP
    }

    /** Replaces Nimbus's painters by flat ones. Their keys have region, states and kind: {@code Button[Focused].backgroundPainter}. */
    static void replaceIn(UIDefaults defaults) {
        for (Object key : defaults.keySet().toArray()) {
            String name = key.toString();
            int states = name.indexOf('[');
            int kind = name.indexOf("].", states);
            if (states > 0 && kind > 0 && name.endsWith("Painter")) {
                FlatPainter painter =
                        of(name.substring(0, states), name.substring(states + 1, kind), name.substring(kind + 2));
                if (painter != null) {
                    defaults.put(key, painter);
                }
            }
        }
    }

    /** The painter for a region; null keeps Nimbus's own. */
    private static FlatPainter of(String region, String states, String painter) {
        Kind kind = kindOf(region, painter);
        return kind == null ? null : new FlatPainter(kind, Arrays.asList(states.split("\\+")));
    }

    private static Kind kindOf(String region, String painter) {
        boolean background = painter.equals("backgroundPainter");
        return switch (region) {
            case "Button", "ToggleButton", "ComboBox", "ToolBar:Button", "ToolBar:ToggleButton" ->
                background ? Kind.BUTTON : null;
            case "ComboBox:\"ComboBox.arrowButton\"" -> background ? Kind.NOTHING : Kind.ARROW_LEFT;
            case "Spinner:\"Spinner.nextButton\"" -> background ? Kind.SPINNER_NEXT : Kind.ARROW_UP;
            case "Spinner:\"Spinner.previousButton\"" -> background ? Kind.SPINNER_PREVIOUS : Kind.ARROW_DOWN;
            case "ComboBox:\"ComboBox.textField\"", "InternalFrame" -> Kind.NOTHING;
            case "TextField", "FormattedTextField", "PasswordField" -> background ? Kind.FIELD_FILL : Kind.FIELD;
            case "Spinner:Panel:\"Spinner.formattedTextField\"" -> background ? Kind.LINED_FIELD : null;
            case "TextArea", "TextPane", "EditorPane" -> background ? Kind.AREA : Kind.NOTHING;
            case "ScrollPane" -> Kind.FRAME;
            case "CheckBox" -> Kind.CHECK;
            case "RadioButton" -> Kind.RADIO;
            case "ScrollBar:\"ScrollBar.button\"", "ScrollBar:ScrollBarTrack" -> Kind.NOTHING;
            case "ScrollBar:ScrollBarThumb" -> Kind.THUMB;
            case "Slider:SliderTrack" -> Kind.SLIDER_TRACK;
            case "Slider:SliderThumb" -> Kind.SLIDER_THUMB;
            case "TabbedPane:TabbedPaneTab" -> Kind.TAB;
            case "TabbedPane:TabbedPaneTabArea" -> Kind.TAB_LINE;
            case "TableHeader:\"TableHeader.renderer\"" -> background ? Kind.HEADER : null;
            case "TableHeader" ->
                painter.equals("ascendingSortIconPainter")
                        ? Kind.ARROW_UP
                        : painter.equals("descendingSortIconPainter") ? Kind.ARROW_DOWN : null;
            case "MenuBar" -> Kind.BAR;
            case "Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem", "MenuBar:Menu" ->
                background ? Kind.ITEM : painter.equals("checkIconPainter") ? Kind.TICK_ITEM : null;
            case "PopupMenu", "ToolTip" -> Kind.POPUP;
            case "ToolBar" -> painter.equals("handleIconPainter") ? null : Kind.BAR;
            case "ProgressBar" -> background ? Kind.PROGRESS_TRACK : Kind.PROGRESS;
            case "Separator", "PopupMenuSeparator" -> Kind.RULE;
            case "SplitPane:SplitPaneDivider" -> background ? Kind.NOTHING : Kind.GRIP;
            default -> null;
        };
    }

    private boolean is(String state) {
        return states.contains(state);
    }

    @Override
    public void paint(Graphics2D graphics, JComponent component, int width, int height) {
        Graphics2D g = Drawing.on(graphics);
        try {
            // The right edge of a spinner's field is the left one of its arrows.
            boolean joins = component instanceof JFormattedTextField
                    && SwingUtilities.getAncestorOfClass(JSpinner.class, component) != null;
            paintKind(g, joins ? width + Theme.exact(JOINT_UNITS) : width, height);
        } finally {
            g.dispose();
        }
    }

    private void paintKind(Graphics2D g, double w, double h) {
        switch (kind) {
            case BUTTON -> box(g, 2, w, h, buttonFill(), buttonLine(), Theme.CONTROL_RADIUS);
            case FIELD_FILL -> box(g, 2, w, h, is("Disabled") ? Ink.SURFACE : Ink.CARD, null, 3);
            case LINED_FIELD -> {
                box(g, 2, w, h, is("Disabled") ? Ink.SURFACE : Ink.CARD, null, 3);
                outline(g, 2, w, h, is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE);
            }
            case SPINNER_NEXT -> arrowBox(g, w, h, 0);
            case SPINNER_PREVIOUS -> arrowBox(g, w, h, -h);
            case FIELD -> outline(g, 2, w, h, is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE);
            case AREA -> fill(g, w, h, is("Disabled") ? Ink.SURFACE : Ink.CARD);
            case FRAME -> frame(g, w, h);
            case CHECK -> check(g, w, h);
            case RADIO -> radio(g, w, h);
            case TICK_ITEM -> tick(g, 0, 0, w, h, Theme.color(Ink.ACCENT));
            case THUMB -> box(g, 3, w, h, is("Enabled") ? Ink.LINE : Ink.CONTROL_LINE, null, 3);
            case SLIDER_TRACK -> track(g, w, h);
            case SLIDER_THUMB -> knob(g, w, h);
            case ARROW_DOWN -> arrow(g, w, h, 0);
            case ARROW_LEFT -> arrow(g, w, h, 1);
            case ARROW_UP -> arrow(g, w, h, 2);
            case TAB -> tab(g, w, h);
            case TAB_LINE, HEADER -> header(g, w, h);
            case ITEM -> fill(g, w, h, Ink.ACCENT_WASH);
            case POPUP -> {
                fill(g, w, h, Ink.CARD);
                edge(g, w, h, Ink.LINE);
            }
            case BAR -> fill(g, w, h, Ink.SURFACE);
            case PROGRESS_TRACK -> box(g, 1, w, h, Ink.ACCENT_WASH, null, 3);
            case PROGRESS -> box(g, 1, w, h, Ink.ACCENT, null, 3);
            case RULE -> rule(g, w, h);
            case GRIP -> Drawing.grip(g, w, h);
            case NOTHING -> {}
        }
    }

    private Ink buttonFill() {
        if (is("Default")) {
            return is("Pressed") ? Ink.TEXT : Ink.ACCENT;
        }
        if (is("Disabled")) {
            return Ink.SURFACE;
        }
        if (is("Selected")) {
            return Ink.ACCENT_WASH;
        }
        return is("Pressed") ? Ink.PRESSED : is("MouseOver") ? Ink.HOVER : Ink.CARD;
    }

    private Ink buttonLine() {
        if (is("Focused") || is("Selected") && !is("Disabled")) {
            return Ink.ACCENT;
        }
        return is("Disabled") ? Ink.LINE : Ink.CONTROL_LINE;
    }

    private void box(Graphics2D g, double inset, double w, double h, Ink fill, Ink line, double radiusUnits) {
        double i = Theme.exact(inset);
        var shape = Drawing.round(i + 0.5, i + 0.5, w - 2 * i - 1, h - 2 * i - 1, Theme.exact(radiusUnits));
        g.setColor(Theme.color(fill));
        g.fill(shape);
        if (line != null) {
            ring(g, w, h, i, radiusUnits);
            g.setColor(Theme.color(line));
            g.setStroke(Theme.hairline());
            g.draw(shape);
        }
    }

    /** Focus: a second line in the accent colour around the first. */
    private void ring(Graphics2D g, double w, double h, double i, double radiusUnits) {
        if (is("Focused")) {
            g.setColor(Theme.color(Ink.ACCENT, 0.45));
            g.setStroke(Theme.stroke(2));
            g.draw(Drawing.round(i - 0.5, i - 0.5, w - 2 * i + 1, h - 2 * i + 1, Theme.exact(radiusUnits + 1)));
        }
    }

    private void outline(Graphics2D g, double inset, double w, double h, Ink line) {
        double i = Theme.exact(inset);
        ring(g, w, h, i, 3);
        g.setColor(Theme.color(is("Disabled") ? Ink.LINE : line));
        g.setStroke(Theme.hairline());
        g.draw(Drawing.round(i + 0.5, i + 0.5, w - 2 * i - 1, h - 2 * i - 1, Theme.exact(3)));
    }

    /** Half of a box of twice the height, with a line towards the field. @param top of the box */
    private void arrowBox(Graphics2D g, double w, double h, double top) {
        double i = Theme.exact(2);
        double beyond = Theme.exact(JOINT_UNITS);
        var shape = Drawing.round(-beyond, top + i + 0.5, w + beyond - i - 0.5, 2 * h - 2 * i - 1, Theme.exact(3));
        g.setColor(Theme.color(buttonFill()));
        g.fill(shape);
        g.setColor(Theme.color(is("Disabled") ? Ink.LINE : Ink.CONTROL_LINE));
        g.setStroke(Theme.hairline());
        g.draw(shape);
        Drawing.fillCrisp(g, 0, Math.max(0, top + i), Theme.exact(1), h - i);
    }

    private static void fill(Graphics2D g, double w, double h, Ink ink) {
        g.setColor(Theme.color(ink));
        Drawing.fillCrisp(g, 0, 0, w, h);
    }

    private static void edge(Graphics2D g, double w, double h, Ink ink) {
        double one = Theme.exact(1);
        g.setColor(Theme.color(ink));
        Drawing.fillCrisp(g, 0, 0, w, one);
        Drawing.fillCrisp(g, 0, h - one, w, one);
        Drawing.fillCrisp(g, 0, 0, one, h);
        Drawing.fillCrisp(g, w - one, 0, one, h);
    }

    private void frame(Graphics2D g, double w, double h) {
        edge(g, w, h, is("Focused") ? Ink.ACCENT : Ink.LINE);
    }

    private void check(Graphics2D g, double w, double h) {
        boolean on = is("Selected");
        Ink line = is("Disabled") ? Ink.LINE : on || is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE;
        box(g, 2, w, h, on && !is("Disabled") ? Ink.ACCENT : Ink.CARD, line, 3);
        if (on) {
            tick(g, 0, 0, w, h, Theme.color(is("Disabled") ? Ink.DISABLED : Ink.ON_ACCENT));
        }
    }

    private static void tick(Graphics2D g, double x, double y, double w, double h, Color color) {
        var path = new Path2D.Double();
        path.moveTo(x + w * 0.30, y + h * 0.52);
        path.lineTo(x + w * 0.44, y + h * 0.66);
        path.lineTo(x + w * 0.71, y + h * 0.36);
        g.setColor(color);
        g.setStroke(Theme.line());
        g.draw(path);
    }

    private void radio(Graphics2D g, double w, double h) {
        double i = Theme.exact(2);
        boolean on = is("Selected");
        Ink line = is("Disabled") ? Ink.LINE : on || is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE;
        g.setColor(Theme.color(Ink.CARD));
        g.fill(new Ellipse2D.Double(i, i, w - 2 * i, h - 2 * i));
        g.setColor(Theme.color(line));
        g.setStroke(Theme.stroke(is("Focused") ? 2 : 1));
        g.draw(new Ellipse2D.Double(i + 0.5, i + 0.5, w - 2 * i - 1, h - 2 * i - 1));
        if (on) {
            double d = w * 0.36;
            g.fill(new Ellipse2D.Double((w - d) / 2, (h - d) / 2, d, d));
        }
    }

    private static void track(Graphics2D g, double w, double h) {
        double thickness = Theme.exact(4);
        g.setColor(Theme.color(Ink.LINE));
        g.fill(Drawing.round(0, (h - thickness) / 2, w, thickness, thickness / 2));
    }

    private void knob(Graphics2D g, double w, double h) {
        double d = Math.min(w, h) - 3;
        var disc = new Ellipse2D.Double((w - d) / 2, (h - d) / 2, d, d);
        g.setColor(Theme.color(is("Disabled") ? Ink.SURFACE : is("Pressed") ? Ink.ACCENT : Ink.CARD));
        g.fill(disc);
        g.setColor(Theme.color(is("Disabled") ? Ink.LINE : Ink.ACCENT));
        g.setStroke(Theme.stroke(is("Focused") ? 2.5 : 1.5));
        g.draw(disc);
    }

    private void arrow(Graphics2D g, double w, double h, int quarterTurns) {
        double r = Theme.exact(3.5);
        g.translate(w / 2, h / 2);
        g.rotate(quarterTurns * Math.PI / 2);
        var path = new Path2D.Double();
        path.moveTo(-r, -r / 2);
        path.lineTo(0, r / 2);
        path.lineTo(r, -r / 2);
        g.setColor(Theme.color(is("Disabled") ? Ink.DISABLED : Ink.QUIET));
        g.setStroke(Theme.line());
        g.draw(path);
    }

    private void tab(Graphics2D g, double w, double h) {
        if (is("MouseOver") && !is("Selected")) {
            fill(g, w, h, Ink.HOVER);
        }
        if (is("Selected")) {
            g.setColor(Theme.color(Ink.ACCENT));
            Drawing.fillCrisp(g, 0, h - Theme.exact(2.5), w, Theme.exact(2.5));
        }
        if (is("Focused")) {
            outline(g, 2, w, h, Ink.ACCENT);
        }
    }

    private static void header(Graphics2D g, double w, double h) {
        fill(g, w, h, Ink.SURFACE);
        g.setColor(Theme.color(Ink.LINE));
        Drawing.fillCrisp(g, 0, h - Theme.exact(1), w, Theme.exact(1));
    }

    private static void rule(Graphics2D g, double w, double h) {
        g.setColor(Theme.color(Ink.LINE));
        if (w >= h) {
            Drawing.fillCrisp(g, 0, h / 2, w, Theme.exact(1));
        } else {
            Drawing.fillCrisp(g, w / 2, 0, Theme.exact(1), h);
        }
    }
}
