// roslib reads and drives a robot: topics, odometry, scan, camera, velocities, an order, what is refused. Then it drives on until it is
// killed.   node roslib_drive.js PORT 1|2
'use strict';
const [port, major] = process.argv.slice(2);
const seconds = count => new Promise((done, failed) => setTimeout(() => failed(new Error('nothing came')), count * 1000).unref());
const within = promise => Promise.race([promise, seconds(30)]);

(async () => {
  const ROSLIB = major === '1' ? require('roslib-1') : await import(process.env.NODE_PATH + '/roslib/dist/RosLib.js');
  const ros = new ROSLIB.Ros({ url: 'ws://127.0.0.1:' + port });
  await within(new Promise((done, failed) => { ros.on('connection', done); ros.on('error', failed); }));
  const topics = await within(new Promise((done, failed) => ros.getTopics(done, failed)));
  console.log('topics', topics.topics.length, topics.types[topics.topics.indexOf('/robot/scan')]);
  console.log('type', await within(new Promise((done, failed) => ros.getTopicType('/cmd_vel', done, failed))));
  const topic = (name, messageType, throttle) => new ROSLIB.Topic({ ros, name, messageType, throttle_rate: throttle });
  const until = (source, wanted) => within(new Promise(done => {
    const heard = message => {
      if (wanted(message)) {
        source.unsubscribe(heard);
        done(message);
      }
    };
    source.subscribe(heard);
  }));
  const scan = await until(topic('/robot/scan', 'sensor_msgs/LaserScan'), () => true);
  console.log('scan', scan.ranges.length, scan.ranges.some(range => range === null));
  const camera = await until(topic('/robot/camera/compressed', 'sensor_msgs/CompressedImage'), () => true);
  const jpeg = Buffer.from(camera.data, 'base64');
  console.log('camera', camera.format, jpeg[0] === 0xff && jpeg[1] === 0xd8 && jpeg.length > 1000);
  const odometry = topic('/robot/odom', 'nav_msgs/Odometry', 100);
  const velocity = topic('/cmd_vel', 'geometry_msgs/Twist');
  const drive = () => velocity.publish({ linear: { x: 0.2, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } });
  let timer = setInterval(drive, 100);
  const driven = await until(odometry, each => each.twist.twist.linear.x > 0.15);
  clearInterval(timer);
  const stood = await until(odometry, each => each.twist.twist.linear.x === 0);
  console.log('odom', driven.header.frame_id, stood.pose.pose.position.x > driven.pose.pose.position.x, 'secs' in stood.header.stamp);
  const order = new ROSLIB.Service({ ros, name: '/robot/order', serviceType: 'simgsm/Order' });
  const reply = await within(new Promise((done, failed) => order.callService({ keys: '** #**20 **' }, done, failed)));
  console.log('order', reply.tone, reply.text);
  const wrong = new ROSLIB.Service({ ros, name: '/nope', serviceType: 'std_srvs/Trigger' });
  console.log('wrong', await within(new Promise((done, failed) => wrong.callService({}, failed, done))));
  timer = setInterval(drive, 50);
  await until(odometry, each => each.twist.twist.linear.x > 0.1);
  console.log('driving');
})().catch(fault => {
  console.log(fault);
  process.exit(1);
});
