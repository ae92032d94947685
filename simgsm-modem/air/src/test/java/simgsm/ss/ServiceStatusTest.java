package simgsm.ss;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;

/** Answers to operations on supplementary services. */
class ServiceStatusTest {
    private static final ServiceStatus FORWARDED =
            new ServiceStatus(SsCode.FORWARDING_UNCONDITIONAL, 7, Optional.of("+5550102"));

    @ParameterizedTest
    @CsvSource({"REGISTER_SS, a011040121300c300a8401078505915505 01f2", "INTERROGATE_SS, a30c300a8401078505915505 01f2"
    })
    void aForwardingIsEncodedAsTheStandardHasIt(SsOperation operation, String hex) {
        assertEquals(
                OctetString.ofHex(hex.replace(" ", "")).toString(),
                FORWARDED.encode(operation).toString());
    }

    @ParameterizedTest
    @EnumSource(
            value = SsOperation.class,
            names = {"REGISTER_SS", "ERASE_SS", "ACTIVATE_SS", "DEACTIVATE_SS", "INTERROGATE_SS"})
    void everyStatusIsReadAsItWasWritten(SsOperation operation) throws ProtocolViolation {
        for (SsCode service : SsCode.values()) {
            for (int flags : new int[] {4, 5, 6, 7}) {
                boolean hasNumber = service.isForwarding() && (flags & ServiceStatus.REGISTERED) != 0;
                boolean isImpossible = flags == 5 && service.isForwarding() || flags > 5 && !service.isForwarding();
                if (!isImpossible) {
                    ServiceStatus status =
                            new ServiceStatus(service, flags, hasNumber ? Optional.of("+5550102") : Optional.empty());
                    assertEquals(
                            status, ServiceStatus.decode(service, operation, status.encode(operation)), operation + "");
                }
            }
        }
    }

    @Test
    void anArgumentWithANumberIsReadAsItWasWritten() throws ProtocolViolation {
        for (String number : new String[] {"5550102", "+5550102", "1"}) {
            SsArgument argument = new SsArgument(0x21, Optional.of(0x8311), Optional.of(number), Optional.of(25));
            assertEquals(argument, SsArgument.decode(argument.encode()));
        }
    }

    @ParameterizedTest
    @CsvSource({"''", "30", "3003040221", "0401 21", "300a0401218405915a5a5a", "3003020121", "30040401218400"})
    void aBrokenArgumentIsAViolation(String hex) {
        assertThrows(ProtocolViolation.class, () -> SsArgument.decode(OctetString.ofHex(hex.replace(" ", ""))));
    }

    @ParameterizedTest
    @CsvSource({"''", "80", "8002", "a1020101", "a3", "a0023000", "a003040121"})
    void aBrokenAnswerIsAViolation(String hex) {
        OctetString octets = OctetString.ofHex(hex);
        assertThrows(
                ProtocolViolation.class,
                () -> ServiceStatus.decode(SsCode.FORWARDING_UNCONDITIONAL, SsOperation.REGISTER_SS, octets));
    }
}
