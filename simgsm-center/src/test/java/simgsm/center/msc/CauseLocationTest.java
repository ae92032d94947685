package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CauseLocation;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.air.TransactionIdentifier;

/** Who gives the causes that the network sends (TS 24.008, 10.5.4.11), and which number it names (TS 24.081, 3). */
class CauseLocationTest {
    private static final TransactionIdentifier CALLED = new TransactionIdentifier(0, true);

    private final TestNetwork network = new TestNetwork();

    @ParameterizedTest
    @CsvSource({"5559999, UNASSIGNED_NUMBER", "1234567890123456, INVALID_NUMBER_FORMAT"})
    void theNetworksOwnRefusalIsThePublicNetworks(String number, Cause cause) {
        TestMobile caller = network.attach("5550100");
        caller.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        StringBuilder swapped = new StringBuilder();
        for (int i = 0; i < number.length(); i += 2) {
            swapped.append(i + 1 < number.length() ? number.charAt(i + 1) : 'f').append(number.charAt(i));
        }
        String called = String.format("5e%02x81%s", swapped.length() / 2 + 1, swapped);
        caller.tellNext("0305", "0406600402000581" + called);

        CallControl.ReleaseComplete refusal = caller.next(CallControl.ReleaseComplete.class);
        assertEquals(Optional.of(cause), refusal.cause());
        assertEquals(Optional.of(CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER), refusal.location());
    }

    @Test
    void theCauseThatTheCalledUserGivesIsPassedOnAsTheUsers() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        caller.next(CallControl.Alerting.class);
        called.tell(new CallControl.Disconnect(CALLED, Cause.CALL_REJECTED));

        CallControl.Disconnect told = caller.next(CallControl.Disconnect.class);
        assertEquals(Cause.CALL_REJECTED, told.cause());
        assertEquals(CauseLocation.USER, told.location());
    }

    @Test
    void aCalledMobileThatIsNotReachedIsTheNetworksCause() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.vanish();
        network.passSeconds(60);

        CallControl.Disconnect told = caller.next(CallControl.Disconnect.class);
        assertEquals(CauseLocation.PUBLIC_NETWORK_OF_LOCAL_USER, told.location());
    }

    @Test
    void connectNamesTheNumberThatAnswers() {
        TestMobile caller = network.attach("5550100");
        TestMobile called = network.attach("5550200");
        caller.dial("5550200");
        caller.next(CallControl.CallProceeding.class);
        called.ring();
        caller.next(CallControl.Alerting.class);
        called.tell(new CallControl.Connect(CALLED));

        assertEquals(
                Optional.of(new Msisdn("5550200")),
                caller.next(CallControl.Connect.class).connected());
    }
}
