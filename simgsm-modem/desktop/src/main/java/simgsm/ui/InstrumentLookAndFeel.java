package simgsm.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.RenderingHints;
import java.util.List;
import javax.swing.UIDefaults;
import javax.swing.plaf.ColorUIResource;
import javax.swing.plaf.FontUIResource;
import javax.swing.plaf.InsetsUIResource;
import javax.swing.plaf.nimbus.NimbusLookAndFeel;
import simgsm.draw.Ink;

/** Nimbus with the theme's colours and fonts and with flat painters. */
final class InstrumentLookAndFeel extends NimbusLookAndFeel {
    private UIDefaults defaults;

    @Override
    public UIDefaults getDefaults() {
        if (defaults == null) {
            defaults = super.getDefaults();
            colours();
            sizes();
            FlatPainter.replaceIn(defaults);
            // arrow keys move through an open list; Enter takes the row, Escape leaves things as they were
            defaults.put("ComboBox.noActionOnKeyNavigation", Boolean.TRUE);
        }
        return defaults;
    }

    @Override
    public String getName() {
        return "SimGSM instrument";
    }

    private void colours() {
        put("control", Ink.SURFACE);
        put("nimbusBase", Ink.ACCENT);
        put("nimbusBlueGrey", Ink.LINE);
        put("nimbusBorder", Ink.LINE);
        put("nimbusLightBackground", Ink.CARD);
        put("nimbusFocus", Ink.ACCENT);
        put("nimbusSelection", Ink.ACCENT);
        put("nimbusSelectionBackground", Ink.ACCENT_WASH);
        put("nimbusSelectedText", Ink.TEXT);
        put("nimbusDisabledText", Ink.DISABLED);
        put("nimbusInfoBlue", Ink.ACCENT);
        put("nimbusRed", Ink.DANGER);
        put("nimbusGreen", Ink.GOOD);
        put("nimbusOrange", Ink.WARNING);
        put("nimbusAlertYellow", Ink.WARNING);
        put("info", Ink.CARD);
        put("menu", Ink.CARD);
        put("menuText", Ink.TEXT);
        put("text", Ink.TEXT);
        put("controlText", Ink.TEXT);
        put("infoText", Ink.TEXT);
        put("textForeground", Ink.TEXT);
        put("textBackground", Ink.ACCENT_WASH);
        put("textHighlight", Ink.ACCENT_WASH);
        put("textHighlightText", Ink.TEXT);
        put("textInactiveText", Ink.DISABLED);
        put("background", Ink.SURFACE);
        put("desktop", Ink.SURFACE);
        put("scrollbar", Ink.SURFACE);
        put("controlHighlight", Ink.CARD);
        put("controlLHighlight", Ink.CARD);
        put("controlShadow", Ink.LINE);
        put("controlDkShadow", Ink.CONTROL_LINE);
        put("Table.alternateRowColor", Ink.CARD);
        put("Table.background", Ink.CARD);
        put("Table.gridColor", Ink.LINE);
        put("Table[Enabled+Selected].textForeground", Ink.TEXT);
        put("Table[Enabled+Selected].textBackground", Ink.ACCENT_WASH);
        put("List.background", Ink.CARD);
        put("List[Selected].textForeground", Ink.TEXT);
        put("List[Selected].textBackground", Ink.ACCENT_WASH);
        put("Tree.background", Ink.CARD);
        put("TextField.caretForeground", Ink.ACCENT);
        put("TextArea.caretForeground", Ink.ACCENT);
        put("ToolTip.background", Ink.CARD);
        for (String item : List.of("Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem")) {
            put(item + "[Enabled].textForeground", Ink.TEXT);
            put(item + "[Disabled].textForeground", Ink.DISABLED);
            put(item + "[MouseOver].textForeground", Ink.TEXT);
            put(item + "[MouseOver]:MenuItemAccelerator.textForeground", Ink.QUIET);
            put(item + ":MenuItemAccelerator.textForeground", Ink.QUIET);
        }
        put("Menu[Enabled+Selected].textForeground", Ink.TEXT);
        put("MenuBar:Menu[Enabled].textForeground", Ink.TEXT);
        put("MenuBar:Menu[Disabled].textForeground", Ink.DISABLED);
        put("MenuBar:Menu[Selected].textForeground", Ink.TEXT);
        put("CheckBoxMenuItem[Enabled+Selected].textForeground", Ink.TEXT);
        put("RadioButtonMenuItem[Enabled+Selected].textForeground", Ink.TEXT);
        put("CheckBoxMenuItem[MouseOver+Selected].textForeground", Ink.TEXT);
        put("RadioButtonMenuItem[MouseOver+Selected].textForeground", Ink.TEXT);
        put("Button[Default].textForeground", Ink.ON_ACCENT);
        for (String state : List.of("Default+Focused", "Default+MouseOver", "Default+Focused+MouseOver")) {
            put("Button[" + state + "].textForeground", Ink.ON_ACCENT);
        }
        put("Button[Default+Pressed].textForeground", Ink.ON_ACCENT);
        put("Button[Default+Focused+Pressed].textForeground", Ink.ON_ACCENT);
    }

    /** State colours are plain Colors, because Synth ignores a renderer's background that is a UIResource. */
    private void put(String key, Ink ink) {
        Color color = Theme.color(ink);
        boolean plain = key.contains("[") || key.endsWith("RowColor");
        defaults.put(key, plain ? color : new ColorUIResource(color));
    }

    /** Multiplies Nimbus's content margins, and the sizes of the buttons in combo boxes, spinners and scroll bars, by the zoom. */
    private void zoom() {
        for (Object key : defaults.keySet().toArray()) {
            String name = key.toString();
            if (name.endsWith(".contentMargins") || name.equals("ComboBox.padding")) {
                if (defaults.get(key) instanceof Insets in) {
                    defaults.put(
                            key,
                            new InsetsUIResource(scaled(in.top), scaled(in.left), scaled(in.bottom), scaled(in.right)));
                }
            } else if (isButtonSize(name) && defaults.get(key) instanceof Integer size) {
                defaults.put(key, scaled(size));
            }
        }
    }

    private static boolean isButtonSize(String name) {
        return name.endsWith("arrowButton\".size")
                || name.endsWith("Spinner.nextButton\".size")
                || name.endsWith("Spinner.previousButton\".size")
                || name.endsWith("ArrowButton.size");
    }

    private static int scaled(int distance) {
        return (int) Math.round(distance * Theme.zoom());
    }

    private void sizes() {
        // four tabs side by side in the centre's window at 1280x720, in Spanish too
        defaults.put("TabbedPane:TabbedPaneTab.contentMargins", new InsetsUIResource(2, 5, 3, 5));
        zoom();
        defaults.put("defaultFont", new FontUIResource(Theme.base()));
        defaults.put("CheckBox.icon", new ToggleIcon(FlatPainter.Kind.CHECK));
        defaults.put("RadioButton.icon", new ToggleIcon(FlatPainter.Kind.RADIO));
        // the same antialiasing as in Drawing, independent of the desktop's setting
        defaults.put(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        defaults.put("Table.rowHeight", Theme.px(24));
        defaults.put("Tree.rowHeight", Theme.px(24));
        defaults.put("ScrollBar.thickness", Theme.px(12));
        defaults.put("ScrollBar.minimumThumbSize", new Dimension(Theme.px(24), Theme.px(24)));
        defaults.put("SplitPane.size", Theme.px(8));
        defaults.put(
                "TabbedPane:TabbedPaneTab.contentMargins",
                new InsetsUIResource(Theme.px(2), Theme.px(6), Theme.px(3), Theme.px(6)));
        defaults.put(
                "TabbedPane:TabbedPaneTabArea.contentMargins",
                new InsetsUIResource(Theme.px(3), Theme.px(2), Theme.px(1), Theme.px(2)));
        defaults.put("Table.showGrid", Boolean.FALSE);
    }
}
