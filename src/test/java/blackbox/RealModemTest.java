package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import vericommand.RobotStatus;

/** The robot behind a real modem, which is emulated with the faults of such modems; with a clock moved by hand. */
class RealModemTest {
    private final RealModemScene scene = new RealModemScene(EmulatedModem.Family.SIM800);
    private final EmulatedModem modem = scene.modem;

    @Test
    void theEventsOfAnOrderAreThoseOfM2() {
        scene.ready().inCall();
        assertEquals("1", scene.tones());
        scene.press("** #**20 **");
        scene.seconds(3);
        assertEquals(0.2, scene.robot.xMeters(), 1e-6);
        assertEquals("163", scene.tones());
        modem.callerHangsUp();
        scene.seconds(1);
        assertEquals(
                List.of(
                        "registered robot=robot number=5550200",
                        "modem robot=robot state=ready text=TestNet",
                        "ringing robot=robot from=5550100",
                        "call robot=robot from=5550100",
                        "tone robot=robot key=1",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=#",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=2",
                        "keys robot=robot keys=0",
                        "keys robot=robot keys=*",
                        "keys robot=robot keys=*",
                        "order robot=robot text=**#**20** verdict=accepted",
                        "status robot=robot value=Moving",
                        "tone robot=robot key=6",
                        "status robot=robot value=Stopped",
                        "pose robot=robot x=0.2000 y=0.0000 heading=0.00",
                        "outcome robot=robot tone=3 text=\"Done: #**20. Stopped at 0.200 0.000 m, heading 0.0.\"",
                        "tone robot=robot key=3",
                        "released robot=robot cause=16"),
                scene.lines);
    }

    @ParameterizedTest
    @EnumSource(EmulatedModem.Family.class)
    void everyDialectOfKeysIsRead(EmulatedModem.Family family) {
        RealModemScene other = new RealModemScene(family);
        other.ready().inCall().press("** #*#90 #**30 **");
        other.seconds(6);
        assertEquals("163", other.tones());
        assertEquals(0.3, other.travelledMetres(), 1e-6);
    }

    @ParameterizedTest
    @ValueSource(strings = {"blank missing", "echo stuck", "half lines", "echo and half lines"})
    void aTalkativeModemIsReadRight(String fault) {
        modem.blankMissing = fault.startsWith("blank");
        modem.echoStuck = fault.startsWith("echo");
        modem.halfLines = fault.endsWith("half lines");
        scene.ready().inCall().press("** #**200 **");
        scene.seconds(8);
        assertEquals("163", scene.tones());
        assertEquals(2, scene.travelledMetres(), 1e-6);
        modem.message(RealModemScene.CALLER, "** #*#180 #**100 **");
        scene.seconds(12);
        assertEquals(1, scene.travelledMetres(), 1e-6);
        assertEquals(1, modem.messagesSent.size());
    }

    @Test
    void aModemThatDropsEqualKeysTakesNoCalls() {
        modem.intervalStuck = true;
        scene.ready().inCall();
        assertFalse(modem.isInCall());
        assertEquals(
                List.of("ringing robot=robot from=5550100", "released robot=robot cause=16"),
                scene.lines.subList(2, 4));
        modem.message(RealModemScene.CALLER, "** #**20 **");
        scene.seconds(5);
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
    }

    @Test
    void aModemThatReportsNoKeysTakesNoCalls() {
        modem.deaf = true;
        scene.ready().inCall();
        assertFalse(modem.isInCall());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "\u0000\u00ff\u0080",
                "+DT",
                "MF: 5\r\n",
                "\r\n+DTMF: 5+DTMF: 6\r\n",
                "\r\n+DTMF: \r\n",
                "garbage\r\n"
            })
    void noiseInMidOrderBreaksTheOrderAndTheNextIsRead(String noise) {
        scene.ready().inCall().press("** #**20");
        modem.raw(noise);
        scene.press("0 **");
        scene.seconds(3);
        assertEquals(0, scene.travelledMetres());
        assertEquals("17", scene.tones());
        scene.press("** #**20 **");
        scene.seconds(3);
        assertEquals("1763", scene.tones());
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
    }

    @Test
    void aModemThatStartsAgainStopsTheRobotAtOnceAndIsCalledAgainWithin5Seconds() {
        scene.ready().inCall().press("** #**500 **");
        scene.seconds(1);
        assertEquals(RobotStatus.MOVING, scene.robot.status());
        modem.reboot();
        scene.seconds(0.05);
        assertEquals(List.of("released robot=robot cause=41"), scene.lines("released"));
        scene.seconds(2);
        assertEquals(RobotStatus.STOPPED, scene.robot.status());
        modem.call(RealModemScene.CALLER);
        scene.seconds(3);
        assertTrue(modem.isInCall());
        scene.press("** #*0 **");
        scene.seconds(1);
        assertEquals("1613", scene.tones());
    }

    @Test
    void aStartIsNoticedByItsLaterCodesToo() {
        scene.ready().inCall().press("** #**500 **");
        modem.raw("\r\n+CPIN: READY\r\n\r\nCall Ready\r\n");
        scene.seconds(0.1);
        assertEquals(List.of(), scene.lines("released"), "they may come late after the start of the line");
        modem.raw("\r\nCall Ready\r\n");
        scene.seconds(0.1);
        assertEquals(List.of("released robot=robot cause=41"), scene.lines("released"));
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void threeSecondsOfSilenceStopTheRobotAndTheModemIsCalledAgain(boolean loses) {
        scene.ready().inCall().press("** #**500 **");
        scene.seconds(1);
        modem.silence(3000, loses);
        scene.seconds(2.9);
        assertEquals(List.of("released robot=robot cause=41"), scene.lines("released"));
        scene.seconds(1);
        assertEquals(RobotStatus.STOPPED, scene.robot.status());
        scene.seconds(3);
        assertTrue(scene.inService());
        assertFalse(modem.isInCall(), "the call is hung up");
        scene.inCall().press("** #*0 **");
        scene.seconds(1);
        assertTrue(scene.tones().endsWith("13"), scene.tones());
    }

    @Test
    void aSilentModemLetsTheRobotStandWithinTwoAndAHalfSecondsWhateverItWasAsked() {
        for (int step = 0; step < 50; step++) {
            RealModemScene each = new RealModemScene(EmulatedModem.Family.SIM800);
            each.ready().inCall().press("** #**500 **");
            each.seconds(3 + step * 0.01);
            assertEquals(RobotStatus.MOVING, each.robot.status());
            each.modem.silence(10_000, true);
            each.seconds(2.5);
            assertEquals(RobotStatus.STOPPED, each.robot.status(), "silent from " + step * 10 + " ms on");
        }
    }

    @Test
    void anOrderWhoseKeysALastingSilenceHasSwallowedIsNotExecuted() {
        scene.ready().inCall().press("** #**2");
        modem.silence(700, true);
        scene.press("0");
        scene.seconds(0.6);
        scene.press("0 **");
        scene.seconds(5);
        assertEquals(0, scene.travelledMetres());
    }

    @Test
    void aPortThatIsClosedFor20SecondsStopsTheRobotAndServesWithin5SecondsOfItsReturn() {
        scene.ready().inCall().press("** #**500 **");
        scene.seconds(1);
        scene.closePort();
        scene.seconds(0.01);
        assertEquals(List.of("released robot=robot cause=41"), scene.lines("released"));
        scene.seconds(2);
        assertEquals(RobotStatus.STOPPED, scene.robot.status());
        assertFalse(scene.inService());
        scene.seconds(18);
        modem.callerHangsUp();
        scene.seconds(1);
        scene.openPort();
        scene.seconds(3);
        modem.call(RealModemScene.CALLER);
        scene.seconds(1);
        assertEquals(2, scene.lines("ringing").size());
        scene.seconds(2);
        scene.press("** #**20 **");
        scene.seconds(3);
        assertTrue(scene.tones().endsWith("163"), scene.tones());
    }

    @Test
    void aMessageIsExecutedOnceAlsoIfItCannotBeErased() {
        modem.eraseRefused = true;
        scene.ready();
        modem.message("+34600111222", "** #**20 **");
        scene.seconds(70);
        scene.closePort();
        scene.seconds(1);
        scene.openPort();
        scene.seconds(70);
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
        assertEquals(1, scene.lines("sms").size());
        assertEquals(1, modem.messagesSent.size());
        assertTrue(
                modem.messagesSent.get(0).startsWith("0011000B914306101122F2"),
                "to the number as it was: " + modem.messagesSent.get(0));
    }

    @Test
    void messagesThatCameWhileTheModemWasAwayAreFetchedAndErased() {
        modem.message(RealModemScene.CALLER, "** #**20 **");
        scene.ready();
        scene.seconds(5);
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
        assertEquals(0, modem.messagesStored());
    }

    @Test
    void aMessageWhoseNoticeIsLostIsFoundWithinHalfAMinute() {
        scene.ready();
        modem.noticesLost = 1;
        modem.message(RealModemScene.CALLER, "** #**20 **");
        scene.seconds(35);
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
        assertEquals(0, modem.messagesStored());
    }

    @Test
    void aModemWithoutPduModeIsUsedInTextMode() {
        modem.textModeOnly = true;
        scene.ready();
        modem.message(RealModemScene.CALLER, "** #**20 **");
        scene.seconds(5);
        assertEquals(0.2, scene.travelledMetres(), 1e-6);
        assertEquals(1, modem.messagesSent.size());
        assertTrue(modem.messagesSent.get(0).startsWith("3 Done: #**20."), modem.messagesSent.get(0));
        assertTrue(modem.commands.contains("AT+CMGS=\"5550100\""));
    }

    @Test
    void aHangUpWhileItRingsReleasesTheCall() {
        scene.ready();
        modem.call(RealModemScene.CALLER);
        scene.seconds(1);
        modem.callerHangsUp();
        scene.seconds(3);
        assertEquals(
                List.of("ringing robot=robot from=5550100", "released robot=robot cause=16"),
                scene.lines.subList(2, 4));
    }

    @Test
    void aMinuteWithoutAKeyClearsTheCall() {
        scene.ready().inCall();
        scene.seconds(58);
        assertTrue(modem.isInCall());
        scene.seconds(4);
        assertFalse(modem.isInCall());
        assertEquals(List.of("released robot=robot cause=16"), scene.lines("released"));
    }

    @Test
    void tenSecondsWithoutAKeyBreakAnOpenOrder() {
        scene.ready().inCall().press("** #**");
        scene.seconds(9);
        assertEquals("1", scene.tones());
        scene.seconds(2);
        assertEquals("17", scene.tones());
    }

    @Test
    void aRobotThatIsOffDeniesTheCallAndClearsIt() {
        scene.ready();
        scene.robot.setPower(false);
        scene.inCall();
        assertEquals("2", scene.tones());
        assertFalse(modem.isInCall());
    }

    @Test
    void aSecondCallIsRefusedAsBusy() {
        scene.ready().inCall();
        modem.secondCall("5550101");
        scene.seconds(1);
        assertFalse(modem.hasWaitingCall());
        assertTrue(modem.isInCall());
    }

    @Test
    void aModemThatIsNotRegisteredIsAwaited() {
        modem.registered = false;
        scene.ready();
        assertEquals(List.of("modem robot=robot state=no-network text=\"+CREG: 1,2\""), scene.lines);
        modem.registered = true;
        scene.seconds(1);
        assertEquals(
                List.of("registered robot=robot number=5550200", "modem robot=robot state=ready text=TestNet"),
                scene.lines.subList(1, 3));
    }

    /** In each of many calls one octet of the line is lost or changed into noise, at another place. */
    @Test
    void whateverOctetIsLostOrDisturbedNoOtherOrderIsExecuted() {
        scene.ready();
        Random random = new Random(11);
        int executed = 0;
        for (int round = 0; round < 100; round++) {
            scene.robot.place(0, 0, 0);
            scene.inCall();
            int[] octetsLeft = {random.nextInt(260)};
            boolean loses = random.nextBoolean();
            scene.line = octets -> disturbed(octets, octetsLeft, loses);
            int centimetres = 1 + random.nextInt(200);
            scene.press("** #**" + centimetres + " **");
            scene.line = octets -> octets;
            scene.seconds(6);
            double travelled = scene.travelledMetres();
            assertTrue(
                    travelled == 0 || Math.abs(travelled - centimetres / 100.0) < 1e-3,
                    centimetres + " cm, travelled " + travelled + " m in round " + round);
            executed += travelled == 0 ? 0 : 1;
            modem.callerHangsUp();
            scene.seconds(2);
        }
        assertTrue(executed > 10 && executed < 100, executed + " executed");
    }

    private static byte[] disturbed(byte[] octets, int[] left, boolean loses) {
        int at = left[0];
        left[0] -= octets.length;
        if (at < 0 || at >= octets.length) {
            return octets;
        }
        String text = new String(octets, StandardCharsets.ISO_8859_1);
        String changed = text.substring(0, at) + (loses ? "" : "\u00fe") + text.substring(at + 1);
        return changed.getBytes(StandardCharsets.ISO_8859_1);
    }
}
