package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.RslMessage;
import simgsm.air.Layer3Type;
import simgsm.ui.glossary.Glossary;

/** Each name that the ladder can show is explained. */
class MessageNamesTest {
    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyMessageOfOurCoreIsExplained(String language) {
        Glossary glossary = Glossary.in(Locale.forLanguageTag(language));
        Stream<String> layer3 = Stream.of(Layer3Type.values()).map(Layer3Type::title);
        Stream<String> link = Stream.of(RslMessage.class.getPermittedSubclasses())
                .filter(type -> !carriesLayer3(type))
                .map(type -> type.getSimpleName().replaceAll("(?<=[a-z])(?=[A-Z])", " "))
                .map(name -> name.replace("Sms ", "SMS "));
        List<String> bare = Stream.concat(layer3, link)
                .filter(name -> glossary.findMessage(name).isEmpty())
                .toList();
        assertEquals(List.of(), bare);
    }

    /** Shown by what they carry. */
    private static boolean carriesLayer3(Class<?> type) {
        return List.of("EstablishIndication", "DataIndication", "DataRequest", "MeasurementResult")
                .contains(type.getSimpleName());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "RP-DATA SUBMIT",
                "RP-DATA DELIVER",
                "RP-DATA STATUS-REPORT",
                "RP-DATA COMMAND",
                "RP-DATA SUBMIT-REPORT",
                "RP-DATA DELIVER-REPORT",
                "RP-ACK",
                "RP-ERROR",
                "RP-SMMA"
            })
    void whatAShortMessagesFrameCarriesIsExplainedToo(String carried) {
        for (String language : List.of("en", "es")) {
            Glossary glossary = Glossary.in(Locale.forLanguageTag(language));
            String name = "CP-DATA (" + carried + ")";
            assertTrue(glossary.findMessage(name).orElseThrow().startsWith("CP-DATA: "));
            assertTrue(glossary.findCarried(name).isPresent(), language + " " + carried);
        }
    }
}
