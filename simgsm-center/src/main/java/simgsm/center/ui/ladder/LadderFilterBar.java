package simgsm.center.ui.ladder;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JTextField;
import simgsm.console.TextBundle;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DocumentChanges;
import simgsm.ui.HintedTextField;
import simgsm.ui.Theme;

/** Selects messages by text, terminal and protocol. */
final class LadderFilterBar extends JPanel {
    private final TextBundle texts;
    private final Runnable changed;
    private final JTextField text;
    private final JComboBox<String> who = new JComboBox<>();
    private final JComboBox<String> kind = new JComboBox<>();
    /** True while the choices are replaced, which selects nothing. */
    private boolean isFilling;

    LadderFilterBar(TextBundle texts, Runnable changed) {
        super(new BorderLayout());
        this.texts = texts;
        this.changed = changed;
        setOpaque(false);
        text = ComponentNames.name(
                new HintedTextField(texts.of("window.ladder.find")),
                "ladder.find",
                texts.of("window.ladder.find.name"));
        text.setToolTipText(texts.of("window.ladder.find.why"));
        ComponentNames.name(who, "ladder.who", texts.of("window.ladder.who"));
        ComponentNames.name(kind, "ladder.kind", texts.of("window.ladder.kind"));
        who.setToolTipText(texts.of("window.ladder.who"));
        kind.setToolTipText(texts.of("window.ladder.kind.why"));
        kind.addItem(texts.of("window.ladder.everything"));
        for (Protocol protocol : Protocol.values()) {
            kind.addItem(protocol.tag());
        }
        offer(List.of());
        who.addActionListener(event -> tell());
        kind.addActionListener(event -> tell());
        text.getDocument().addDocumentListener(new DocumentChanges(this::tell));
        add(Arrange.row(Theme.GRID, Arrange.growing(text), who, kind));
    }

    /** Hides the protocols where they would be cut, unless one is chosen. */
    @Override
    public void doLayout() {
        int both = who.getPreferredSize().width + kind.getPreferredSize().width + 2 * Theme.px(Theme.GRID);
        boolean isShown = both <= getWidth() || kind.getSelectedIndex() > 0;
        if (isShown != kind.isVisible()) {
            kind.setVisible(isShown);
        }
        super.doLayout();
    }

    private void tell() {
        if (!isFilling) {
            changed.run();
        }
    }

    LadderFilter filter() {
        Optional<Protocol> protocol = kind.getSelectedIndex() <= 0
                ? Optional.empty()
                : Optional.of(Protocol.values()[kind.getSelectedIndex() - 1]);
        return new LadderFilter(terminal(), protocol, text.getText());
    }

    private Optional<String> terminal() {
        return who.getSelectedIndex() <= 0 ? Optional.empty() : Optional.of(who.getItemAt(who.getSelectedIndex()));
    }

    void choose(String terminal) {
        who.setSelectedItem(terminal);
    }

    /** Offers these terminals; keeps the selection if it is among them. */
    void offer(List<String> terminals) {
        List<String> sorted = new ArrayList<>(terminals);
        sorted.sort(String::compareTo);
        List<String> present = new ArrayList<>();
        for (int i = 1; i < who.getItemCount(); i++) {
            present.add(who.getItemAt(i));
        }
        if (who.getItemCount() > 0 && present.equals(sorted)) {
            return;
        }
        Optional<String> chosen = terminal();
        isFilling = true;
        who.removeAllItems();
        who.addItem(texts.of("window.ladder.everybody"));
        sorted.forEach(who::addItem);
        chosen.filter(sorted::contains).ifPresent(who::setSelectedItem);
        isFilling = false;
        if (chosen.isPresent() && terminal().isEmpty()) {
            changed.run();
        }
    }
}
