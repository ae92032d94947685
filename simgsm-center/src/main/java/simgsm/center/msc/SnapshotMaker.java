package simgsm.center.msc;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import simgsm.center.msc.call.CallSwitch;
import simgsm.center.msc.call.CallView;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.center.subscriber.SubscriberRegister;

/** Makes the snapshots of an exchange. */
final class SnapshotMaker {
    private static final int MOST_ENDED = 100;

    private final SubscriberRegister register;
    private final CallSwitch calls;
    private final ShortMessageCenter shortMessages;
    private final Ladder ladder;
    private final Broadcaster broadcaster;
    private final Deque<CallView> endedCalls = new ArrayDeque<>();
    private ExchangeSnapshot.Passing latestCall;
    private ShortMessage latestMessage;
    private boolean latestIsCall;

    SnapshotMaker(
            SubscriberRegister register,
            CallSwitch calls,
            ShortMessageCenter shortMessages,
            Ladder ladder,
            Broadcaster broadcaster) {
        this.register = register;
        this.calls = calls;
        this.shortMessages = shortMessages;
        this.ladder = ladder;
        this.broadcaster = broadcaster;
    }

    void callBegan(CallView call) {
        latestCall = new ExchangeSnapshot.Passing(call.from(), call.to(), "");
        latestIsCall = true;
    }

    void callEnded(CallView call) {
        endedCalls.addFirst(call);
        if (endedCalls.size() > MOST_ENDED) {
            endedCalls.removeLast();
        }
    }

    void messageAccepted(ShortMessage message) {
        latestMessage = message;
        latestIsCall = false;
    }

    /** Makes a snapshot; the first one starts the decoding of keys. */
    ExchangeSnapshot make(Instant time, int links) {
        calls.keyTap().watch();
        int most = ExchangeSnapshot.MAX_ROWS;
        return new ExchangeSnapshot(
                time,
                links,
                register.attachedCount(),
                shortMessages.waitingCount(),
                calls.speechFramesSwitched(),
                register.all().stream()
                        .limit(most)
                        .map(each -> ExchangeSnapshot.SubscriberRow.of(
                                each, register.home().isBarred(each.imsi())))
                        .toList(),
                calls.calls().stream().limit(most).map(CallView::of).toList(),
                messages(most),
                ladder.entries(),
                ladder.passedCount(),
                latest(),
                broadcaster.running(),
                List.copyOf(endedCalls));
    }

    /** Decodes the message's text only here, because most messages are never shown. */
    private Optional<ExchangeSnapshot.Passing> latest() {
        if (latestIsCall) {
            return Optional.of(withKeys(latestCall));
        }
        return Optional.ofNullable(latestMessage)
                .map(message -> new ExchangeSnapshot.Passing(
                        message.from(), message.to().digits(), message.text()));
    }

    private ExchangeSnapshot.Passing withKeys(ExchangeSnapshot.Passing call) {
        return new ExchangeSnapshot.Passing(
                call.from(), call.to(), calls.keyTap().keys());
    }

    /** Waiting messages first, then up to 100 ended ones. */
    private List<ExchangeSnapshot.MessageRow> messages(int most) {
        List<MessageHistory> histories =
                new ArrayList<>(shortMessages.messages().waitingHistories(most));
        histories.addAll(shortMessages.messages().endedHistories(Math.min(MOST_ENDED, most - histories.size())));
        return histories.stream()
                .map(history ->
                        new ExchangeSnapshot.MessageRow(history.message().text(), history))
                .toList();
    }
}
