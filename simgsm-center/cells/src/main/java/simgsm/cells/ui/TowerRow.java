package simgsm.cells.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Graphics;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import simgsm.cells.snapshot.CellState;
import simgsm.cells.snapshot.TownActions;
import simgsm.cells.town.Tower;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.Slider;
import simgsm.ui.Theme;

/** One tower: switched on and off by its check box, its power set by a fader. */
final class TowerRow extends JPanel {
    private static final int LEAST_DBM = 0;
    private static final int MOST_DBM = 60;
    private static final int NAME_UNITS = 96;
    private static final int POWER_UNITS = 52;

    private final TextBundle texts;
    private final JCheckBox on;
    private final Slider fader;
    private final JLabel power = Theme.label("", Theme::monoSmall, Ink.TEXT);
    private final String details;
    private boolean isShowing;

    TowerRow(TextBundle texts, TownActions town, Tower tower, int index) {
        super(new BorderLayout());
        this.texts = texts;
        setOpaque(false);
        on = new JCheckBox(tower.name()) {
            @Override
            public Dimension getPreferredSize() {
                return new Dimension(Theme.px(NAME_UNITS), super.getPreferredSize().height);
            }
        };
        on.addActionListener(event -> town.switchTower(tower.name(), on.isSelected()));
        details = texts.of(
                "tower.why", tower.name(), String.valueOf(tower.arfcn()), String.valueOf(tower.bsic()), tower.unitId());
        on.setToolTipText(details);
        ComponentNames.name(on, "tower." + tower.name(), texts.of("tower.switch", tower.name()));
        int initial = (int) Math.round(tower.powerDbm());
        fader = new Slider(LEAST_DBM, Math.max(MOST_DBM, initial), initial, () -> setPower(town, tower.name()));
        ComponentNames.name(fader, "power." + tower.name(), texts.of("tower.power", tower.name()));
        fader.setToolTipText(texts.of("tower.power", tower.name()));
        power.setName("dbm." + tower.name());
        add(Arrange.row(Theme.HALF, new Swatch(index), on, Arrange.growing(fader), fixed(power)), BorderLayout.CENTER);
    }

    private static JComponent fixed(JLabel label) {
        JPanel cell = new JPanel(new BorderLayout()) {
            @Override
            public Dimension getPreferredSize() {
                return new Dimension(Theme.px(POWER_UNITS), label.getPreferredSize().height);
            }
        };
        cell.setOpaque(false);
        label.setHorizontalAlignment(JLabel.RIGHT);
        cell.add(label, BorderLayout.CENTER);
        return cell;
    }

    private void setPower(TownActions town, String name) {
        power.setText(texts.of("tower.dbm", String.valueOf(fader.getValue())));
        town.setPower(name, fader.getValue());
    }

    void show(CellState state) {
        on.setSelected(state.isOn());
        on.setForeground(Theme.color(state.refusal().isEmpty() ? Ink.TEXT : Ink.DANGER));
        on.setToolTipText(state.refusal().isEmpty() ? details : texts.of("tower.refused", details, state.refusal()));
        if (!fader.hasFocus() || !isShowing) {
            fader.show((int) Math.round(state.powerDbm()));
        }
        isShowing = true;
        power.setText(texts.of("tower.dbm", String.valueOf(fader.getValue())));
    }

    /** The colour of the cell on the map. */
    private static final class Swatch extends JComponent {
        private static final int UNITS = 8;
        private final int index;

        Swatch(int index) {
            this.index = index;
        }

        @Override
        public Dimension getPreferredSize() {
            return new Dimension(Theme.px(UNITS), Theme.px(UNITS));
        }

        @Override
        protected void paintComponent(Graphics g) {
            g.setColor(Theme.color(CellInk.of(index)));
            g.fillRect(0, (getHeight() - Theme.px(2.0 * UNITS)) / 2, getWidth(), Theme.px(2.0 * UNITS));
        }
    }
}
