package simgsm.modem;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.air.RejectCause;

class RepliesTest {
    private static final long MINUTE = 60_000;

    private final CalledModem scene = new CalledModem();

    @BeforeEach
    void endTheCall() {
        scene.callerHangsUp();
        scene.told.clear();
    }

    private int reply() {
        return scene.modem.reply(CalledModem.CALLER, "3 Done.");
    }

    @Test
    void aReplyIsSentOnceAndReported() {
        int id = reply();
        scene.pass(50_000);
        assertEquals(List.of("sms sent " + id), scene.told);
        assertEquals(1, scene.messagesSubmitted());
    }

    @Test
    void aReplyThatFindsNoServiceForMinutesIsSentWhenThereIsService() {
        scene.lose();
        int id = reply();
        scene.pass(5 * MINUTE);
        assertTrue(scene.told.isEmpty());
        scene.findAgain();
        scene.pass(1_000);
        assertEquals(List.of("sms sent " + id), scene.told);
        assertEquals(1, scene.messagesSubmitted());
    }

    @Test
    void afterTenMinutesAReplyIsGivenUp() {
        scene.lose();
        int id = reply();
        scene.pass(10 * MINUTE - 20);
        assertTrue(scene.told.isEmpty());
        scene.pass(MINUTE);
        assertEquals(List.of("sms failed " + id + " 38"), scene.told);
        scene.findAgain();
        scene.pass(MINUTE);
        assertEquals(0, scene.messagesSubmitted());
    }

    @Test
    void ofMoreThanTwentyTheOldestIsGivenUp() {
        List<Integer> ids = new ArrayList<>();
        scene.refusal = Optional.of(RejectCause.CONGESTION);
        for (int i = 0; i < Replies.MAX_KEPT + 1; i++) {
            ids.add(reply());
            scene.pass(100);
        }
        assertEquals(List.of("sms failed " + ids.get(0) + " 38"), scene.told);
        scene.refusal = Optional.empty();
        scene.pass(MINUTE);
        assertEquals(Replies.MAX_KEPT, scene.messagesSubmitted());
        assertTrue(scene.told.contains("sms sent " + ids.get(Replies.MAX_KEPT)));
    }

    @Test
    void aMessageThatIsNoReplyFailsAsTheStationSays() {
        scene.lose();
        int id = scene.modem.station().sendMessage(CalledModem.CALLER, "hello");
        scene.pass(40_000);
        assertEquals(List.of("sms failed " + id + " 38"), scene.told);
    }

    @Test
    void aModemThatIsSwitchedOffKeepsNothing() {
        scene.lose();
        int id = reply();
        scene.modem.station().powerOff();
        assertEquals(List.of("sms failed " + id + " 38"), scene.told);
    }
}
