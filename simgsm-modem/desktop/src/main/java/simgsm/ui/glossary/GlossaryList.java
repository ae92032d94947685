package simgsm.ui.glossary;

import java.awt.BorderLayout;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import simgsm.draw.Ink;
import simgsm.ui.Arrange;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.DocumentChanges;
import simgsm.ui.Theme;
import simgsm.ui.VerticalScrollPane;
import simgsm.ui.pane.WrappedColumn;

/** All terms with their explanations; a field selects those that contain a word. Needs no display. */
public final class GlossaryList extends JPanel {
    private final Glossary glossary;
    private final GlossaryText text = GlossaryText.ofExplanations("glossary.text");
    private final JTextField wanted = new JTextField();

    public GlossaryList(Locale language) {
        super(new BorderLayout());
        glossary = Glossary.in(language);
        ComponentNames.name(wanted, "glossary.find", DesktopTexts.in(language).of("glossary.find"));
        wanted.setToolTipText(DesktopTexts.in(language).of("glossary.find"));
        wanted.getDocument().addDocumentListener(new DocumentChanges(() -> show(wanted.getText())));
        JPanel column = Arrange.column(Theme.GRID, text);
        JScrollPane scroll = new VerticalScrollPane(new WrappedColumn(column)).bare();
        JLabel label = Theme.label(DesktopTexts.in(language).of("glossary.find"), Theme::base, Ink.TEXT);
        label.setLabelFor(wanted);
        JPanel find = Arrange.row(Theme.GRID, label, Arrange.growing(wanted));
        JPanel all = Arrange.column(Theme.GRID, find, Arrange.growing(scroll));
        all.setBorder(Theme.padding(12));
        add(all, BorderLayout.CENTER);
        Theme.styled(this, panel -> panel.setBackground(Theme.color(Ink.SURFACE)));
        show("");
    }

    private void show(String word) {
        String lower = word.strip().toLowerCase(Locale.ROOT);
        StringBuilder found = new StringBuilder();
        for (String term : glossary.terms()) {
            String entry = term + ": " + glossary.find(term).orElse("");
            if (entry.toLowerCase(Locale.ROOT).contains(lower)) {
                found.append(found.isEmpty() ? "" : "\n\n").append(entry);
            }
        }
        text.show(found.toString());
    }
}
