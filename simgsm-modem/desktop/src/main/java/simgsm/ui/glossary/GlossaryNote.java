package simgsm.ui.glossary;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JPanel;

/**
 * The explanation of a term below the component that names it; hidden without one. Glossary and text are made at the
 * first explanation, so that the window opens sooner.
 */
public final class GlossaryNote extends JPanel {
    private final Locale language;
    private Glossary glossary;
    private GlossaryText text;

    public GlossaryNote(Locale language) {
        super(new BorderLayout());
        this.language = language;
        setOpaque(false);
        setVisible(false);
    }

    /** Explains a GSM message by its name, and the message it carries. */
    public void explainMessage(String name) {
        show(Stream.of(glossary().findMessage(name), glossary().findCarried(name))
                .flatMap(Optional::stream)
                .collect(Collectors.joining("\n\n")));
    }

    /** Explains the first term of a text; hides the note if there is none. */
    public void explain(String words) {
        List<Glossary.Part> parts = words.isEmpty() ? List.of() : glossary().parts(words);
        show(parts.stream()
                .map(Glossary.Part::term)
                .filter(each -> !each.isEmpty())
                .findFirst()
                .map(name -> name + ": " + glossary().find(name).orElse(""))
                .orElse(""));
    }

    private Glossary glossary() {
        if (glossary == null) {
            glossary = Glossary.in(language);
        }
        return glossary;
    }

    private void show(String explanation) {
        if (!explanation.isEmpty()) {
            if (text == null) {
                text = GlossaryText.ofExplanations("glossary.note");
                add(text, BorderLayout.CENTER);
            }
            text.show(explanation);
        }
        setVisible(!explanation.isEmpty());
        revalidate();
    }
}
