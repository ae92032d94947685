package simrobot.source.child;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.behaviour.BehaviourRequest;

class RequestLineTest {
    /** The words of docs/BEHAVIOUR.md, "Python and other languages". */
    @Test
    void eachRequestHasTheWordOfThePage() {
        Map<String, BehaviourRequest> lines = Map.of(
                "sms robot=1 to=5550100 text=hi", new BehaviourRequest.Sms("5550100", "hi"),
                "tones robot=1 keys=12", new BehaviourRequest.Tones("12"),
                "drive robot=1 place=Library", new BehaviourRequest.DriveTo("Library"),
                "mark robot=1 x=0 y=1 toX=2 toY=3 text=a", new BehaviourRequest.Mark(0, 1, 2, 3, "a"),
                "keys robot=1", new BehaviourRequest.Keys());
        lines.forEach((line, request) ->
                assertEquals(Optional.of(request), PipeLine.parse(line).flatMap(RequestLine::parse), line));
    }
}
