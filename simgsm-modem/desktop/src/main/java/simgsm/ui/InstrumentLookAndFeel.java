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
            for (Class<?> plain : List.of(PlainLabelUI.class, PlainToolTipUI.class)) {
                defaults.put(plain.getSimpleName().replace("Plain", ""), plain.getName());
                defaults.put(plain.getName(), plain);
            }
            // arrow keys move through an open list; Enter takes the row, Escape cancels
            defaults.put("ComboBox.noActionOnKeyNavigation", Boolean.TRUE);
        }
        return defaults;
    }

    @Override
    public String getName() {
        return "SimGSM instrument";
    }

    private void colours() {
        put(Ink.SURFACE, "control background desktop scrollbar");
        put(Ink.ACCENT, """
                nimbusBase nimbusFocus nimbusSelection nimbusInfoBlue TextField.caretForeground
                TextArea.caretForeground
                """);
        put(Ink.LINE, "nimbusBlueGrey nimbusBorder controlShadow Table.gridColor");
        put(Ink.CARD, """
                nimbusLightBackground info menu controlHighlight controlLHighlight Table.alternateRowColor
                Table.background List.background ToolTip.background
                """);
        put(Ink.ACCENT_WASH, """
                nimbusSelectionBackground textBackground textHighlight Table[Enabled+Selected].textBackground
                List[Selected].textBackground
                """);
        put(Ink.TEXT, """
                nimbusSelectedText menuText text controlText infoText textForeground textHighlightText
                Table[Enabled+Selected].textForeground List[Selected].textForeground
                Menu[Enabled+Selected].textForeground CheckBoxMenuItem[Enabled+Selected].textForeground
                RadioButtonMenuItem[Enabled+Selected].textForeground
                CheckBoxMenuItem[MouseOver+Selected].textForeground
                RadioButtonMenuItem[MouseOver+Selected].textForeground
                """);
        put(Ink.DISABLED, "nimbusDisabledText textInactiveText");
        put(Ink.DANGER, "nimbusRed");
        put(Ink.GOOD, "nimbusGreen");
        put(Ink.WARNING, "nimbusOrange nimbusAlertYellow");
        put(Ink.CONTROL_LINE, "controlDkShadow");
        put(Ink.ON_ACCENT, """
                Button[Default].textForeground Button[Default+Pressed].textForeground
                Button[Default+Focused+Pressed].textForeground Button[Default+Focused].textForeground
                Button[Default+MouseOver].textForeground Button[Default+Focused+MouseOver].textForeground
                """);
        defaults.put("Menu[Enabled+Selected].arrowIconPainter", defaults.get("Menu[Enabled].arrowIconPainter"));
        for (String item : List.of("Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem")) {
            put(Ink.TEXT, item + "[Enabled].textForeground " + item + "[MouseOver].textForeground");
            put(Ink.DISABLED, item + "[Disabled].textForeground");
            String accelerator = ":MenuItemAccelerator.textForeground";
            put(Ink.QUIET, item + ":MenuItemAccelerator[MouseOver].textForeground " + item + accelerator);
        }
    }

    /**
     * Sets the colour of keys separated by white space. State colours are plain Colors, because Synth ignores a
     * renderer's background that is a UIResource.
     */
    private void put(Ink ink, String keys) {
        Color color = Theme.color(ink);
        for (String key : keys.strip().split("\\s+")) {
            boolean plain = key.contains("[") || key.endsWith("RowColor");
            defaults.put(key, plain ? color : new ColorUIResource(color));
        }
    }

    /**
     * Multiplies Nimbus's content margins and the button sizes of combo boxes, spinners and scroll bars by the zoom.
     */
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
        zoom();
        defaults.put("defaultFont", new FontUIResource(Theme.base()));
        defaults.put("CheckBox.icon", new CheckBoxIcon());
        // the same antialiasing as in Drawing, independent of the desktop's setting
        defaults.put(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        defaults.put("Table.rowHeight", Theme.px(24));
        defaults.put("ScrollBar.thickness", Theme.px(12));
        defaults.put("ScrollBar.minimumThumbSize", new Dimension(Theme.px(24), Theme.px(24)));
        defaults.put(
                "TabbedPane:TabbedPaneTab.contentMargins",
                new InsetsUIResource(Theme.px(2), Theme.px(6), Theme.px(3), Theme.px(6)));
        defaults.put(
                "TabbedPane:TabbedPaneTabArea.contentMargins",
                new InsetsUIResource(Theme.px(3), Theme.px(2), Theme.px(1), Theme.px(2)));
        defaults.put("Table.showGrid", Boolean.FALSE);
    }
}
