package simgsm.ui.glossary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GlossaryTest {
    private final Glossary english = Glossary.in(Locale.ENGLISH);
    private final Glossary spanish = Glossary.in(Locale.forLanguageTag("es"));

    @Test
    void bothLanguagesExplainTheSameTerms() {
        assertEquals(english.terms().size(), spanish.terms().size());
        assertEquals(
                List.of(),
                english.terms().stream()
                        .filter(term -> spanish.find(term).isEmpty())
                        .toList());
        assertTrue(english.terms().size() > 40);
    }

    @Test
    void aSpanishTermIsListedByItsSpanishName() {
        assertTrue(spanish.terms().containsAll(List.of("traspaso", "verosimilitud", "ley A", "mensaje Hold")));
        assertTrue(spanish.terms().stream().noneMatch(term -> term.startsWith("message ")));
    }

    @Test
    void aTermIsFoundByAnyOfItsNamesInAnyLetters() {
        assertEquals(english.find("IMEI"), english.find("tmsi"));
        assertTrue(spanish.find("traspaso").isPresent());
        assertEquals(Optional.empty(), english.find("nothing"));
    }

    @Test
    void aPluralIsItsTerm() {
        assertEquals(
                List.of(
                        Glossary.Part.plain("dos "),
                        new Glossary.Part("traspasos", "traspaso"),
                        Glossary.Part.plain("")),
                spanish.parts("dos traspasos"));
    }

    @Test
    void aTextIsSplitAtTheFirstPlaceOfEachTerm() {
        assertEquals(
                List.of(
                        Glossary.Part.plain("The "),
                        new Glossary.Part("RP-ACK", "RP-DATA"),
                        Glossary.Part.plain(" is no paging-thing, nor RP-ACK again")),
                english.parts("The RP-ACK is no paging-thing, nor RP-ACK again"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void aChannelAndTheCodeOfACellHaveTheirOwnEntries(String language) {
        assertTrue(Glossary.in(Locale.forLanguageTag(language)).terms().containsAll(List.of("ARFCN", "BSIC")));
    }
}
