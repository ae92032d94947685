package simgsm.ui.lesson;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JPanel;
import simgsm.lesson.Glossary;

/** The explanation of a term below what names it; hidden without one. */
public final class GlossaryNote extends JPanel {
    private final Glossary glossary;
    private final GlossaryText text = new GlossaryText("glossary.note", Optional.empty(), term -> {});

    public GlossaryNote(Locale language) {
        super(new BorderLayout());
        glossary = Glossary.in(language);
        setOpaque(false);
        add(text, BorderLayout.CENTER);
        setVisible(false);
    }

    /** Explains a GSM message by its name, and what it carries. */
    public void explainMessage(String name) {
        List<String> found = Stream.of(glossary.findMessage(name), glossary.findCarried(name))
                .flatMap(Optional::stream)
                .toList();
        text.show(String.join("\n\n", found));
        setVisible(!found.isEmpty());
        revalidate();
    }

    /** Explains the first term in a text; without a term in it, nothing is shown. */
    public void explain(String words) {
        Optional<String> term = glossary.parts(words).stream()
                .map(Glossary.Part::term)
                .filter(each -> !each.isEmpty())
                .findFirst();
        term.ifPresent(name -> text.show(name + ": " + glossary.find(name).orElse("")));
        setVisible(term.isPresent());
        revalidate();
    }
}
