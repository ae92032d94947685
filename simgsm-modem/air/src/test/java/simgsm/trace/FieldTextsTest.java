package simgsm.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslElement;
import simgsm.air.CauseLocation;
import simgsm.air.Direction;
import simgsm.air.Element;
import simgsm.air.Layer3Type;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.RelayType;

class FieldTextsTest {
    private static final Set<String> ENGLISH = keys(Locale.ROOT);
    private static final Set<String> SPANISH = keys(Locale.forLanguageTag("es"));

    @Test
    void bothLanguagesHaveTheSameTexts() {
        assertEquals(ENGLISH, SPANISH);
    }

    @Test
    void everyComponentOfAMessageHasAName() {
        Stream<Element> layer3 = Stream.of(Layer3Type.values())
                .flatMap(type -> Stream.of(Direction.values()).flatMap(way -> type.elements(way).stream()));
        Stream<Element> relay = Stream.of(RelayType.values())
                .flatMap(type -> Stream.of(Direction.values()).flatMap(way -> type.elements(way).stream()));
        Stream.concat(layer3, relay)
                .flatMap(row -> row.components().stream())
                .filter(name -> !Set.of("facility", "relay").contains(name))
                .forEach(name -> assertTrue(SPANISH.contains(name), name));
    }

    @Test
    void everyValueAndElementOfALinkHasAName() {
        Stream.<Enum<?>[]>of(
                        CauseLocation.values(),
                        MobileIdentity.Type.values(),
                        MobilityManagement.ServiceType.values(),
                        MobilityManagement.LocationUpdatingType.values(),
                        RslElement.values())
                .flatMap(Arrays::stream)
                .forEach(value -> assertTrue(SPANISH.contains(value.name()), value.name()));
    }

    private static Set<String> keys(Locale language) {
        return ResourceBundle.getBundle("simgsm.trace.fields", language).keySet();
    }
}
