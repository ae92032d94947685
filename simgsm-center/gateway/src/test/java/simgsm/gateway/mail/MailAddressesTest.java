package simgsm.gateway.mail;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The forms of TS 23.040, 3.8. */
class MailAddressesTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            ignoreLeadingAndTrailingWhitespace = false,
            value = {
                "ann@example.org Hello there|ann@example.org|||Hello there",
                "ann@example.org(Subject)Hello|ann@example.org||Subject|Hello",
                "ann@example.org##Subject#Hello # all|ann@example.org||Subject|Hello # all",
                "ann@example.org#Ann#Hello|ann@example.org|||Hello",
                "ann@example.org#Ann##Subject#Hello|ann@example.org|Ann|Subject|Hello",
                "ann@example.org,bob@x.org Hello|ann@example.org,bob@x.org|||Hello",
                "ann*example.org Hello|ann@example.org|||Hello",
                "ann$b*example.org Hello|ann_b@example.org|||Hello",
                "ann@host|ann@host|||",
            })
    void aTextThatBeginsWithAnAddressIsReadInEachForm(
            String text, String to, String name, String subject, String message) {
        MailAddresses read = MailAddresses.parse(text).orElseThrow();
        assertEquals(to, String.join(",", read.to()));
        assertEquals(name == null ? "" : name, read.name());
        assertEquals(subject == null ? "" : subject, read.subject());
        assertEquals(message == null ? "" : message, read.text());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "**#**20**",
                "** #**20 **",
                "** #*0 **",
                "*#0*",
                "**A12*B34**",
                "1*2",
                "hello",
                "a@b@c x",
                "a@.org x",
                "@b.org x",
                "",
                "Done. Stopped.",
            })
    void anOrderOrAnyOtherTextIsNoAddress(String text) {
        assertEquals(Optional.empty(), MailAddresses.parse(text));
    }

    @Test
    void aTextOfTheLongestMessageIsReadInBoundedDepth() {
        assertEquals(Optional.empty(), MailAddresses.parse("a@" + "a.".repeat(19_000)));
        assertEquals(Optional.empty(), MailAddresses.parse("a.".repeat(19_000)));
    }
}
