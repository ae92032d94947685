package blackbox.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.CaptureTest;
import blackbox.FinishedProgram;
import blackbox.RunningProgram;
import blackbox.Scenario;
import blackbox.SecondCallTest;
import blackbox.UssdTest;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Wireshark reads the centre's captures without any setting. */
@Tag("peer")
class WiresharkTest {
    @TempDir
    Path cards;

    @BeforeAll
    static void requireTshark() {
        Peer.TSHARK.require();
    }

    @Test
    void everyMessageOfADayIsNamedAndSound() throws Exception {
        try (Scenario scenario = new Scenario("a captured day, read by Wireshark")) {
            Path file = scenario.folder().resolve("day.pcap");
            CaptureTest.day(scenario, file);
            Wireshark.requireSound(
                    file,
                    "Location Updating Request",
                    "Location Updating Accept",
                    "CM Service Request",
                    "Paging Response",
                    "Setup",
                    "Call Confirmed",
                    "Alerting",
                    "Connect Acknowledge",
                    "Start DTMF Acknowledge",
                    "Stop DTMF",
                    "Disconnect",
                    "Release Complete",
                    "CP-DATA (RP) RP-DATA",
                    "CP-ACK",
                    "IMSI Detach Indication",
                    "Channel Release",
                    "SMS BroadCast");
        }
    }

    @Test
    void authenticationInAClosedNetworkIsNamedAndSound() throws Exception {
        Path list = cards.resolve("class.hlr");
        FinishedProgram made = FinishedProgram.run(
                "simgsm-center", "--hlr", list.toString(), "--new-sim", Scenario.PHONE + "," + Scenario.ROBOT);
        assertEquals(0, made.status(), made.error());
        Path card = cards.resolve(Scenario.PHONE + ".sim");
        Path wrong = Files.writeString(
                cards.resolve("wrong.sim"),
                Files.readString(card).replaceFirst(" k=[0-9a-f]+", " k=00112233445566778899aabbccddeeff"));
        try (Scenario scenario = new Scenario("registrations in a closed network, read by Wireshark")) {
            Path capture = scenario.folder().resolve("closed.pcap");
            RunningProgram center = scenario.center("--hlr", list.toString(), "--capture", capture.toString());
            refused(scenario, "3", Scenario.PHONE, "--sim", wrong.toString());
            refused(scenario, "3", Scenario.PHONE);
            refused(scenario, "2", "5559999");
            assertEquals(
                    0, scenario.phone(Scenario.PHONE, "--sim", card.toString()).quit());
            center.expect("detached", "number", Scenario.PHONE);
            assertEquals(0, center.quit());
            Wireshark.requireSound(
                    capture,
                    "Authentication Request",
                    "Authentication Response",
                    "Authentication Failure",
                    "Authentication Reject",
                    "Location Updating Reject",
                    "Identity Request",
                    "Identity Response",
                    "Location Updating Accept",
                    "TMSI Reallocation Complete");
        }
    }

    @Test
    void everySupplementaryServiceIsNamedAndSound() throws Exception {
        try (Scenario scenario = new Scenario("supplementary services, read by Wireshark")) {
            Path capture = scenario.folder().resolve("services.pcap");
            RunningProgram center = scenario.center("--capture", capture.toString());
            scenario.robot("empty.map");
            UssdTest.session(scenario.phone(Scenario.PHONE));
            assertEquals(0, center.quit());
            Wireshark.requireSound(
                    capture,
                    "(SS) Register (GSM MAP) invoke processUnstructuredSS-Request",
                    "(SS) Register (GSM MAP) invoke unstructuredSS-Request",
                    "(SS) Facility (GSM MAP) invoke unstructuredSS-Request",
                    "(SS) Facility (GSM MAP) returnResultLast unstructuredSS-Request",
                    "(SS) Release Complete (GSM MAP) returnResultLast processUnstructuredSS-Request",
                    "(SS) Register (GSM MAP) invoke interrogateSS",
                    "(SS) Release Complete (GSM MAP) returnResultLast interrogateSS",
                    "(SS) Register (GSM MAP) invoke registerSS",
                    "(SS) Release Complete (GSM MAP) returnResultLast registerSS",
                    "(SS) Register (GSM MAP) invoke eraseSS",
                    "(SS) Release Complete (GSM MAP) returnResultLast activateSS",
                    "(SS) Release Complete (GSM MAP) returnResultLast deactivateSS",
                    "(SS) Release Complete (GSM MAP) returnError");
            List<String> texts = Wireshark.fields(capture, "gsm_map.ussd_string", "gsm_map.ussd_string");
            assertTrue(texts.contains("*100#"), texts.toString());
        }
    }

    @Test
    void callsThatAreHeldAndRetrievedAreNamedAndSound() throws Exception {
        try (Scenario scenario = new Scenario("calls on hold, read by Wireshark")) {
            Path capture = scenario.folder().resolve("hold.pcap");
            RunningProgram center = scenario.center("--call-waiting", "on", "--capture", capture.toString());
            SecondCallTest.swap(scenario.phone(Scenario.PHONE), scenario.phone("5550101"), scenario.phone("5550102"));
            assertEquals(0, center.quit());
            Wireshark.requireSound(
                    capture,
                    "(CC) Hold",
                    "(CC) Hold Acknowledge",
                    "(CC) Retrieve",
                    "(CC) Retrieve Acknowledge",
                    "(CC) Call Confirmed");
        }
    }

    @Test
    void emergencyForwardingHiddenNumberAndTimeAreNamedAndSound() throws Exception {
        try (Scenario scenario = new Scenario("emergency call, forwarding, time, read by Wireshark")) {
            Path capture = scenario.folder().resolve("network.pcap");
            RunningProgram center = scenario.center("--capture", capture.toString());
            RunningProgram caller = scenario.phone(Scenario.PHONE);
            RunningProgram forwarding = scenario.phone("5550101");
            RunningProgram receiver = scenario.phone("5550102");
            forwarding.say("dial **21*5550102#");
            forwarding.expect("service", "state", "active");
            caller.say("dial #31#5550101");
            receiver.expect("forwarded-by", "number", "5550101");
            caller.say("hangup");
            receiver.expect("released");
            caller.say("dial 112");
            caller.expect("released", "cause", "16");
            caller.expectNext("released", "cause", "16");
            assertEquals(0, center.quit());
            Wireshark.requireSound(
                    capture,
                    "(CC) Emergency Setup",
                    "(MM) MM Information",
                    "(CC) Setup",
                    "(CC) Facility (GSM MAP) invoke notifySS");
            String words = Wireshark.words(capture, "gsm_a.dtap");
            for (String word : new String[] {
                "Redirecting Party BCD Number", "CLIR Invocation", "Time Zone and Time", "Emergency call establishment"
            }) {
                assertTrue(words.contains(word), word + " is not named");
            }
        }
    }

    private static void refused(Scenario scenario, String cause, String number, String... options) throws Exception {
        RunningProgram phone = scenario.unregisteredPhone(number, options);
        phone.expect("unregistered", "cause", cause);
        assertEquals(0, phone.quit());
    }
}
