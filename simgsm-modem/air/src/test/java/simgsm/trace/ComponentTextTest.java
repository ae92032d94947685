package simgsm.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.SupplementaryService.SsFacility;
import simgsm.air.SupplementaryService.SsRegister;
import simgsm.air.SupplementaryService.SsReleaseComplete;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;

class ComponentTextTest {
    private static final TransactionIdentifier TRANSACTION = new TransactionIdentifier(0, false);

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            a10b02010002010e3003040121               | interrogateSS
            a1060201000201c8                         | operation 200
            a210020101300b02013b300604010f040131     | result processUnstructuredSS-Request
            a203020105                               | result
            a306020101020115                         | error facility not supported
            a3060201010201c8                         | error 200
            a406020103810101                         | reject unrecognized operation
            a4050500800102                           | reject badly structured component
            ff00                                     | unreadable component
            """)
    void aComponentNamesItsMessage(String hex, String name) {
        OctetString facility = OctetString.ofHex(hex);
        assertEquals(Optional.of(name), ComponentText.nameOf(new SsRegister(TRANSACTION, facility, Optional.empty())));
        assertEquals(Optional.of(name), ComponentText.nameOf(new SsFacility(TRANSACTION, facility)));
        assertEquals(Optional.of(name), ComponentText.nameOf(new SsReleaseComplete(TRANSACTION, facility)));
    }

    @Test
    void aMessageWithoutAComponentIsNotNamed() {
        assertEquals(Optional.empty(), ComponentText.nameOf(new SsReleaseComplete(TRANSACTION)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            a10b02010002010e3003040121           | invoke 0; operation 14 interrogateSS; parameter 3003040121
            a1060201000201c8                     | invoke 0; operation 200 operation 200
            a210020101300b02013b300604010f040131 | result of invoke 1; operation 59 processUnstructuredSS-Request; text 1
            a203020105                           | result of invoke 5
            a306020101020115                     | error of invoke 1; error 21 facility not supported
            a406020103810101                     | reject of invoke 3; problem unrecognized operation
            a4050500800102                       | reject of invoke unknown; problem badly structured component
            """)
    void aComponentIsReportedFieldByField(String hex, String expected) {
        FieldList fields = new FieldList(FieldTexts.in(Locale.ROOT));
        ComponentText.add(fields, OctetString.ofHex(hex), 0);
        assertEquals(
                expected,
                fields.fields().stream()
                        .map(field -> field.name() + " " + field.value())
                        .collect(Collectors.joining("; ")));
    }

    @Test
    void whatIsWrongWithAComponentIsReported() {
        FieldList fields = new FieldList(FieldTexts.in(Locale.ROOT));
        ComponentText.add(fields, OctetString.ofHex("ff00"), 0);
        assertEquals(
                "[wrong: unrecognized component: its tag is 0xff]",
                fields.fields().toString());
    }
}
