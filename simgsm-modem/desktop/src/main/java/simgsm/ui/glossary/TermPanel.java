package simgsm.ui.glossary;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JPanel;
import simgsm.ui.Arrange;
import simgsm.ui.Theme;

/** Some terms of the glossary as links above the explanation of the chosen one. Needs no display. */
public final class TermPanel extends JPanel {
    private final Glossary glossary;
    private final GlossaryText links;
    private final GlossaryText explanation = GlossaryText.ofExplanations("terms.explanation");

    /** @param terms by any of their names */
    public TermPanel(Locale language, List<String> terms) {
        super(new BorderLayout());
        glossary = Glossary.in(language);
        links = new GlossaryText("terms.links", Optional.of(glossary), this::explain);
        links.show(String.join(" \u00b7 ", terms));
        setOpaque(false);
        Theme.styled(this, panel -> panel.setBorder(Theme.padding(4, 0, 4, 0)));
        add(Arrange.column(Theme.HALF, links, explanation), BorderLayout.CENTER);
        explain(terms.get(0));
    }

    private void explain(String term) {
        glossary.find(term).ifPresent(found -> explanation.show(term + ": " + found));
        revalidate();
    }

    /** Puts the keyboard on the first term. */
    public void focusFirst() {
        links.requestFocusInWindow();
    }
}
