package simgsm.gateway.mail;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.time.InstantSource;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CorrespondencesTest {
    @ParameterizedTest
    @CsvSource({"6245, 624512345678, 624512345679", "34600123456, 346001234565678, 346001234565679"})
    void aMailsNumberIsTheServicesWithTheTimeInAtMost15Digits(String service, String first, String second) {
        Correspondences mails = new Correspondences(service, InstantSource.fixed(Instant.ofEpochMilli(9_912_345_678L)));
        Correspondences.Mail mail = new Correspondences.Mail("5550200", "ann@example.org", "", "");
        assertEquals(first, mails.add(mail));
        assertEquals(second, mails.add(mail));
    }
}
