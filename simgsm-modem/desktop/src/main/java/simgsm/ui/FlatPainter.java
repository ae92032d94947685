package simgsm.ui;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFormattedTextField;
import javax.swing.JSpinner;
import javax.swing.Painter;
import javax.swing.SwingUtilities;
import javax.swing.UIDefaults;
import simgsm.draw.Ink;

/**
 * Paints one region of a Nimbus component in one set of states: a fill, a thin line, a ring for the focus, or a mark
 * such as an arrow or a tick. Components not used by any window, such as trees and progress bars, keep Nimbus's
 * painters.
 */
record FlatPainter(Look look, List<String> states) implements Painter<JComponent> {
    /** Width of a box outside its part of a spinner. */
    private static final double JOINT_UNITS = 8;

    /** The picture of a region with a size in pixels; the painter knows the states. */
    interface Look {
        void paint(FlatPainter painter, Graphics2D g, double width, double height);
    }

    private static final Look NOTHING = (painter, g, w, h) -> {};
    private static final Look ARROW_DOWN = (painter, g, w, h) -> painter.arrow(g, w, h, 0);
    /** Rotated by Synth to the direction of the arrow button. */
    private static final Look ARROW_LEFT = (painter, g, w, h) -> painter.arrow(g, w, h, 1);

    private static final Look ARROW_UP = (painter, g, w, h) -> painter.arrow(g, w, h, 2);

    /** Replaces Nimbus's painters by flat ones. Their keys have region, states and kind: {@code Button[Focused].backgroundPainter}. */
    static void replaceIn(UIDefaults defaults) {
        for (Object key : defaults.keySet().toArray()) {
            String name = key.toString();
            int states = name.indexOf('[');
            int kind = name.indexOf("].", states);
            if (states > 0 && kind > 0 && name.endsWith("Painter")) {
                Look look = look(name.substring(0, states), name.substring(kind + 2));
                if (look != null) {
                    defaults.put(
                            key,
                            new FlatPainter(
                                    look,
                                    List.of(name.substring(states + 1, kind).split("\\+"))));
                }
            }
        }
    }

    /** The look of a region; null keeps Nimbus's. */
    private static Look look(String region, String painter) {
        boolean background = painter.equals("backgroundPainter");
        return switch (region) {
            case "Button", "ToggleButton", "ComboBox" -> background ? FlatPainter::button : null;
            case "ComboBox:\"ComboBox.arrowButton\"" -> background ? NOTHING : ARROW_LEFT;
            case "Spinner:\"Spinner.nextButton\"" ->
                background ? (painted, g, w, h) -> painted.spinnerButton(g, w, h, 0) : ARROW_UP;
            case "Spinner:\"Spinner.previousButton\"" ->
                background ? (painted, g, w, h) -> painted.spinnerButton(g, w, h, -h) : ARROW_DOWN;
            case "ComboBox:\"ComboBox.textField\"" -> NOTHING;
            case "TextField", "FormattedTextField" -> background ? FlatPainter::field : FlatPainter::fieldLine;
            case "Spinner:Panel:\"Spinner.formattedTextField\"" -> background ? FlatPainter::linedField : null;
            case "TextArea", "EditorPane" -> background ? FlatPainter::area : NOTHING;
            case "ScrollPane" -> FlatPainter::frame;
            case "CheckBox" -> FlatPainter::check;
            case "ScrollBar:\"ScrollBar.button\"", "ScrollBar:ScrollBarTrack" -> NOTHING;
            case "ScrollBar:ScrollBarThumb" -> FlatPainter::thumb;
            case "TabbedPane:TabbedPaneTab" -> FlatPainter::tab;
            case "TabbedPane:TabbedPaneTabArea" -> FlatPainter::header;
            case "TableHeader:\"TableHeader.renderer\"" -> background ? FlatPainter::header : null;
            case "TableHeader" ->
                painter.equals("ascendingSortIconPainter")
                        ? ARROW_UP
                        : painter.equals("descendingSortIconPainter") ? ARROW_DOWN : null;
            case "Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem" ->
                background
                        ? (painted, g, w, h) -> fill(g, w, h, Ink.ACCENT_WASH)
                        : painter.equals("checkIconPainter") ? (painted, g, w, h) -> tick(g, w, h, Ink.ACCENT) : null;
            case "PopupMenu", "ToolTip" -> FlatPainter::popup;
            case "PopupMenuSeparator" -> FlatPainter::rule;
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
            look.paint(this, g, joins ? width + Theme.exact(JOINT_UNITS) : width, height);
        } finally {
            g.dispose();
        }
    }

    private void button(Graphics2D g, double w, double h) {
        box(g, 2, w, h, buttonFill(), buttonLine(), Theme.CONTROL_RADIUS);
    }

    private void field(Graphics2D g, double w, double h) {
        box(g, 2, w, h, is("Disabled") ? Ink.SURFACE : Ink.CARD, null, 3);
    }

    private void fieldLine(Graphics2D g, double w, double h) {
        outline(g, w, h, is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE);
    }

    private void linedField(Graphics2D g, double w, double h) {
        field(g, w, h);
        fieldLine(g, w, h);
    }

    private void area(Graphics2D g, double w, double h) {
        fill(g, w, h, is("Disabled") ? Ink.SURFACE : Ink.CARD);
    }

    private void thumb(Graphics2D g, double w, double h) {
        box(g, 3, w, h, is("Enabled") ? Ink.LINE : Ink.CONTROL_LINE, null, 3);
    }

    private void popup(Graphics2D g, double w, double h) {
        fill(g, w, h, Ink.CARD);
        edge(g, w, h, Ink.LINE);
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

    private void outline(Graphics2D g, double w, double h, Ink line) {
        double i = Theme.exact(2);
        ring(g, w, h, i, 3);
        g.setColor(Theme.color(is("Disabled") ? Ink.LINE : line));
        g.setStroke(Theme.hairline());
        g.draw(Drawing.round(i + 0.5, i + 0.5, w - 2 * i - 1, h - 2 * i - 1, Theme.exact(3)));
    }

    /** Half of a box of twice the height, with a line towards the field. @param top of the box */
    private void spinnerButton(Graphics2D g, double w, double h, double top) {
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

    void check(Graphics2D g, double w, double h) {
        boolean on = is("Selected");
        Ink line = is("Disabled") ? Ink.LINE : on || is("Focused") ? Ink.ACCENT : Ink.CONTROL_LINE;
        box(g, 2, w, h, on && !is("Disabled") ? Ink.ACCENT : Ink.CARD, line, 3);
        if (on) {
            tick(g, w, h, is("Disabled") ? Ink.DISABLED : Ink.ON_ACCENT);
        }
    }

    private static void tick(Graphics2D g, double w, double h, Ink ink) {
        var path = new Path2D.Double();
        path.moveTo(w * 0.30, h * 0.52);
        path.lineTo(w * 0.44, h * 0.66);
        path.lineTo(w * 0.71, h * 0.36);
        g.setColor(Theme.color(ink));
        g.setStroke(Theme.line());
        g.draw(path);
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
            outline(g, w, h, Ink.ACCENT);
        }
    }

    private void header(Graphics2D g, double w, double h) {
        fill(g, w, h, Ink.SURFACE);
        g.setColor(Theme.color(Ink.LINE));
        Drawing.fillCrisp(g, 0, h - Theme.exact(1), w, Theme.exact(1));
    }

    private void rule(Graphics2D g, double w, double h) {
        g.setColor(Theme.color(Ink.LINE));
        Drawing.fillCrisp(g, 0, h / 2, w, Theme.exact(1));
    }
}
