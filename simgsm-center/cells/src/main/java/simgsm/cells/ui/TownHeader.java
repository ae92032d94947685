package simgsm.cells.ui;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.snapshot.TownSnapshot;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Lamp;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;

/** The town's name, port and controller, and the switches of the map. */
final class TownHeader extends JPanel {
    private static final int GAP_UNITS = 12;

    private final TextBundle texts;
    private final JLabel title;
    private final JLabel port = Theme.label("", Theme::base, Ink.QUIET);
    private final Lamp controller;
    private final JToggleButton pause;
    private final JPanel row;

    TownHeader(TextBundle texts, TownActions town, TownMap map, TownSnapshot first) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        title = Theme.label(first.town().name(), () -> Theme.sans(20, true), Ink.TEXT);
        title.setName("town");
        port.setText(texts.of("header.port", String.valueOf(first.port())));
        port.setToolTipText(texts.of("header.port.why", String.valueOf(first.port())));
        port.setName("port");
        controller = new Lamp(texts.of("header.controller"));
        controller.setName("controller");
        pause = new JToggleButton(Symbol.PAUSE.icon());
        pause.addActionListener(event -> town.pause(pause.isSelected()));
        pause.setToolTipText(texts.of("header.pause"));
        ComponentNames.name(pause, "pause", texts.of("header.pause"));
        title.setToolTipText(port.getText() + ": " + port.getToolTipText());
        row = Arrange.row(
                GAP_UNITS,
                title,
                port,
                controller,
                Arrange.spring(),
                layer("levels", map::showLevels),
                layer("borders", map::showBorders),
                layer("paths", map::showPaths),
                pause);
        add(row, BorderLayout.CENTER);
        show(first);
    }

    /** Moves the port to the title's tool tip if there is no space. */
    @Override
    public void doLayout() {
        int own = port.getPreferredSize().width + Theme.px(GAP_UNITS);
        int needed = row.getMinimumSize().width + (port.isVisible() ? 0 : own);
        if (port.isVisible() != needed <= getWidth()) {
            port.setVisible(needed <= getWidth());
        }
        super.doLayout();
    }

    private JCheckBox layer(String name, Consumer<Boolean> show) {
        JCheckBox box = new JCheckBox(texts.of("layer." + name), true);
        box.addActionListener(event -> show.accept(box.isSelected()));
        box.setToolTipText(texts.of("layer." + name + ".why"));
        return ComponentNames.name(box, "layer." + name, texts.of("layer." + name + ".why"));
    }

    void show(TownSnapshot snapshot) {
        pause.setSelected(snapshot.isPaused());
        String name = snapshot.isOsmocom() ? "osmo-bsc" : "M3";
        String word = name + " " + snapshot.controller();
        switch (snapshot.link()) {
            case UP -> controller.show(StatusMark.DISC, Ink.GOOD, word);
            case PARTLY -> controller.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("header.partly", word));
            case SEARCHING -> controller.show(StatusMark.HALF_DISC, Ink.WARNING, texts.of("header.searching", word));
        }
    }
}
